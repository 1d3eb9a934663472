#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

namespace fourwis
{

/// A cost c and rows g that depend on a few variables of a nonlinear program.
class NlpElement
{
public:
  using Pattern = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

  struct Derivatives
  {
    Eigen::VectorXd gradient;  ///< dc/dx
    Eigen::MatrixXd jacobian;  ///< dg/dx
    Eigen::MatrixXd hessian;   ///< d2/dx2 of s c + y' g, both triangles
  };

  virtual ~NlpElement() = default;

  /// Sets `rows` to g and returns c. `x` are the values of `variables` in their order.
  virtual double evaluate(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> rows) const = 0;

  /// Every derivative is zero before the call: only what differs from zero must be written.
  virtual void differentiate(const Eigen::VectorXd& x, double s, const Eigen::VectorXd& y,
                             Derivatives& derivatives) const = 0;

  const std::vector<int> variables;           ///< indices in the program, no two alike
  Eigen::VectorXd row_lower, row_upper;       ///< row_lower <= g <= row_upper
  Pattern jacobian_pattern, hessian_pattern;  ///< where derivatives may differ from zero

protected:
  /// All rows 0, all derivatives different from zero; for the constructors of derived classes to change.
  NlpElement(std::vector<int> the_variables, Eigen::Index rows)
    : variables(std::move(the_variables)),
      row_lower(Eigen::VectorXd::Zero(rows)),
      row_upper(Eigen::VectorXd::Zero(rows)),
      jacobian_pattern(Pattern::Constant(rows, size(), true)),
      hessian_pattern(Pattern::Constant(size(), size(), true))
  {}

private:
  Eigen::Index size() const { return static_cast<Eigen::Index>(variables.size()); }
};

/// Nonlinear program: the least sum of the elements' costs with all their rows and lower <= x <= upper.
struct Nlp
{
  std::vector<double> lower, upper;  ///< +-infinity where there is no bound; equal: the variable is fixed
  std::vector<double> start;
  std::vector<std::unique_ptr<const NlpElement>> elements;

  /// Index of a new variable.
  int add_variable(double least, double most, double value)
  {
    lower.push_back(least);
    upper.push_back(most);
    start.push_back(value);
    return static_cast<int>(start.size()) - 1;
  }

  /// Holds a variable at its start.
  void fix(int index)
  {
    const std::size_t i = static_cast<std::size_t>(index);
    lower[i] = upper[i] = start[i];
  }
};

/// Whether bounds and start are valid numbers.
bool is_valid(const Nlp& nlp);

}  // namespace fourwis
