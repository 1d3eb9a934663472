#pragma once

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "fourwis_navigation/ocp/model.h"
#include "fourwis_navigation/ocp/problem.h"
#include "nlp.h"

namespace fourwis
{

/// Cost and dynamics of one stage, of (x_k, u_k, x_{k+1}).
template <class Model>
class StageElement : public NlpElement
{
public:
  static constexpr int NX = Model::kStates, NZ = Model::kStates + Model::kControls;

  /// Keeps a reference to the model. `first` is the index of the first component of x_k.
  StageElement(const Model& model, std::size_t k, int first) : NlpElement(indices(first), NX), model_(model), k_(k)
  {
    jacobian_pattern.rightCols(NX).matrix() = Pattern::Constant(NX, NX, false).matrix();
    jacobian_pattern.rightCols(NX).matrix().diagonal().setConstant(true);
    hessian_pattern.bottomRows(NX).setConstant(false);
    hessian_pattern.rightCols(NX).setConstant(false);
  }

  double evaluate(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> rows) const override
  {
    typename Model::Value value;
    model_.evaluate(k_, state(x), control(x), x.template tail<NX>(), value);
    rows = value.defect;
    return value.cost;
  }

  void differentiate(const Eigen::VectorXd& x, double s, const Eigen::VectorXd& y, Derivatives& d) const override
  {
    // The model knows the second derivatives of c + y' F only: those of s c + y' F take those of c in addition.
    const typename Model::Derivatives all = derivatives(x, y);
    d.gradient.template head<NZ>() = all.gradient;
    d.jacobian.template leftCols<NZ>() = all.jacobian;
    d.jacobian.template rightCols<NX>().diagonal().setConstant(-1.0);
    d.hessian.template topLeftCorner<NZ, NZ>() = all.hessian;
    if (s != 1.0)
      d.hessian.template topLeftCorner<NZ, NZ>() += (s - 1.0) * derivatives(x, Eigen::VectorXd::Zero(NX)).hessian;
  }

private:
  static std::vector<int> indices(int first)
  {
    std::vector<int> result(NZ + NX);
    std::iota(result.begin(), result.end(), first);
    return result;
  }
  static typename Model::State state(const Eigen::VectorXd& x) { return x.template head<NX>(); }
  static typename Model::Control control(const Eigen::VectorXd& x) { return x.segment<Model::kControls>(NX); }

  typename Model::Derivatives derivatives(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const
  {
    typename Model::Derivatives result;
    result.jacobian.setZero();
    result.gradient.setZero();
    result.hessian.setZero();
    model_.differentiate(k_, state(x), control(x), y, result);
    return result;
  }

  const Model& model_;
  const std::size_t k_;
};

/// The terminal cost, of x_N.
template <class Model>
class TerminalElement : public NlpElement
{
public:
  static constexpr int NX = Model::kStates;

  TerminalElement(const Model& model, std::vector<int> state) : NlpElement(std::move(state), 0), model_(model) {}

  double evaluate(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd>) const override
  {
    return model_.terminal_cost(x);
  }

  void differentiate(const Eigen::VectorXd& x, double s, const Eigen::VectorXd&, Derivatives& d) const override
  {
    typename Model::Terminal terminal = {Model::State::Zero(), ocp::Matrix<NX, NX>::Zero()};
    model_.differentiate_terminal(x, terminal);
    d.gradient = terminal.gradient;
    d.hessian = s * terminal.hessian;
  }

private:
  const Model& model_;
};

/// The rows g_i - e_i <= c_i of one stage, of the leading components q of (x_k, u_k) and of the excesses e_i, which
/// cost.
template <class Model>
class RowsElement : public NlpElement
{
public:
  static constexpr int NQ = Model::kRowPoint;

  /// `point` are the indices of q, which may be fewer than NQ at k = N; `excess` those of e, -1 for a hard row.
  RowsElement(const Model& model, std::size_t k, const std::vector<int>& point, const std::vector<int>& excess,
              const std::vector<ocp::RowLimit>& limits)
    : NlpElement(joined(point, excess), static_cast<Eigen::Index>(limits.size())),
      model_(model),
      k_(k),
      point_size_(static_cast<Eigen::Index>(point.size())),
      limits_(limits)
  {
    row_lower.setConstant(-ocp::kInfinity);
    jacobian_pattern.rightCols(jacobian_pattern.cols() - point_size_).setConstant(false);
    hessian_pattern.setConstant(false);
    hessian_pattern.topLeftCorner(point_size_, point_size_).setConstant(true);
    Eigen::Index column = point_size_;
    for (std::size_t i = 0; i < limits.size(); ++i)
    {
      const Eigen::Index row = static_cast<Eigen::Index>(i);
      row_upper[row] = limits[i].upper;
      excess_column_.push_back(excess[i] < 0 ? -1 : column++);
      if (excess[i] >= 0) jacobian_pattern(row, excess_column_[i]) = true;
    }
  }

  double evaluate(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> rows) const override
  {
    model_.rows(k_, point(x), ocp::RowValues(rows.data(), rows.size()));
    double cost = 0.0;
    for_excesses([&](Eigen::Index row, Eigen::Index column, double weight) {
      rows[row] -= x[column];
      cost += weight * x[column];
    });
    return cost;
  }

  void differentiate(const Eigen::VectorXd& x, double, const Eigen::VectorXd& y, Derivatives& d) const override
  {
    Eigen::Matrix<double, NQ, Eigen::Dynamic> gradients = Eigen::Matrix<double, NQ, Eigen::Dynamic>::Zero(NQ, y.size());
    typename Model::RowHessian hessian = Model::RowHessian::Zero();
    model_.differentiate_rows(k_, point(x), ocp::RowMultipliers(y.data(), y.size()),
                              typename Model::Gradients(gradients.data(), NQ, y.size()), hessian);
    d.jacobian.leftCols(point_size_) = gradients.transpose().leftCols(point_size_);
    d.hessian.topLeftCorner(point_size_, point_size_) = hessian.topLeftCorner(point_size_, point_size_);
    for_excesses([&](Eigen::Index row, Eigen::Index column, double weight) {
      d.jacobian(row, column) = -1.0;
      d.gradient[column] = weight;
    });
  }

private:
  static std::vector<int> joined(std::vector<int> point, const std::vector<int>& excess)
  {
    std::copy_if(excess.begin(), excess.end(), std::back_inserter(point), [](int index) { return index >= 0; });
    return point;
  }

  typename Model::RowPoint point(const Eigen::VectorXd& x) const
  {
    typename Model::RowPoint q = Model::RowPoint::Zero();
    q.head(point_size_) = x.head(point_size_);
    return q;
  }

  /// Calls visit(row, column of the excess, weight) for the rows that may be exceeded.
  template <typename Visit>
  void for_excesses(Visit visit) const
  {
    for (std::size_t i = 0; i < limits_.size(); ++i)
      if (excess_column_[i] >= 0) visit(static_cast<Eigen::Index>(i), excess_column_[i], limits_[i].weight);
  }

  const Model& model_;
  const std::size_t k_;
  const Eigen::Index point_size_;
  const std::vector<ocp::RowLimit> limits_;
  std::vector<Eigen::Index> excess_column_;
};

}  // namespace fourwis
