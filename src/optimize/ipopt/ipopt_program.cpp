#include "ipopt_program.h"

#include <algorithm>
#include <cmath>

namespace fourwis
{
namespace
{

/// Calls visit(row, column) for the entries of a Jacobian's pattern, in the order in which Ipopt is given them.
template <typename Visit>
void for_entries(const NlpElement::Pattern& pattern, Visit visit)
{
  for (Eigen::Index i = 0; i < pattern.rows(); ++i)
    for (Eigen::Index j = 0; j < pattern.cols(); ++j)
      if (pattern(i, j)) visit(i, j);
}

/// The same for the entries of a Hessian's pattern that make one of the two triangles of the program's Hessian.
template <typename Visit>
void for_triangle(const NlpElement::Pattern& pattern, Visit visit)
{
  for (Eigen::Index i = 0; i < pattern.rows(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      if (pattern(i, j)) visit(i, j);
}

}  // namespace

IpoptProgram::IpoptProgram(const Nlp& nlp, const Interrupt& interrupt) : nlp_(nlp), interrupt_(interrupt), x_(nlp.start)
{
  for (const auto& element : nlp.elements)
  {
    first_row_.push_back(rows_);
    rows_ += static_cast<int>(element->row_lower.size());
    for_entries(element->jacobian_pattern, [&](Eigen::Index, Eigen::Index) { ++jacobian_entries_; });
    for_triangle(element->hessian_pattern, [&](Eigen::Index, Eigen::Index) { ++hessian_entries_; });
  }
}

/// The i-th element, its variables in local_x_ and space for its rows in local_rows_.
const NlpElement& IpoptProgram::gather(std::size_t i, const double* x)
{
  const NlpElement& element = *nlp_.elements[i];
  local_x_.resize(static_cast<Eigen::Index>(element.variables.size()));
  for (std::size_t j = 0; j < element.variables.size(); ++j)
    local_x_[static_cast<Eigen::Index>(j)] = x[element.variables[j]];
  local_rows_.resize(element.row_lower.size());
  return element;
}

/// Derivatives of the i-th element; y are the multipliers of all rows, null for zeros.
const NlpElement::Derivatives& IpoptProgram::differentiate(std::size_t i, const double* x, double s, const double* y)
{
  const NlpElement& element = gather(i, x);
  const Eigen::Index size = local_x_.size(), rows = local_rows_.size();
  if (y)
    local_y_ = Eigen::Map<const Eigen::VectorXd>(y + first_row_[i], rows);
  else
    local_y_.setZero(rows);
  derivatives_.gradient.setZero(size);
  derivatives_.jacobian.setZero(rows, size);
  derivatives_.hessian.setZero(size, size);
  element.differentiate(local_x_, s, local_y_, derivatives_);
  return derivatives_;
}

bool IpoptProgram::get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& jacobian_entries,
                                Ipopt::Index& hessian_entries, IndexStyleEnum& index_style)
{
  n = static_cast<Ipopt::Index>(nlp_.start.size());
  m = rows_;
  jacobian_entries = jacobian_entries_;
  hessian_entries = hessian_entries_;
  index_style = C_STYLE;
  return true;
}

bool IpoptProgram::get_bounds_info(Ipopt::Index, Ipopt::Number* x_l, Ipopt::Number* x_u, Ipopt::Index,
                                   Ipopt::Number* g_l, Ipopt::Number* g_u)
{
  std::copy(nlp_.lower.begin(), nlp_.lower.end(), x_l);
  std::copy(nlp_.upper.begin(), nlp_.upper.end(), x_u);
  for (std::size_t i = 0; i < nlp_.elements.size(); ++i)
  {
    const NlpElement& element = *nlp_.elements[i];
    std::copy_n(element.row_lower.data(), element.row_lower.size(), g_l + first_row_[i]);
    std::copy_n(element.row_upper.data(), element.row_upper.size(), g_u + first_row_[i]);
  }
  return true;
}

bool IpoptProgram::get_starting_point(Ipopt::Index, bool, Ipopt::Number* x, bool, Ipopt::Number*, Ipopt::Number*,
                                      Ipopt::Index, bool, Ipopt::Number*)
{
  std::copy(nlp_.start.begin(), nlp_.start.end(), x);
  return true;
}

bool IpoptProgram::eval_f(Ipopt::Index, const Ipopt::Number* x, bool, Ipopt::Number& f)
{
  f = 0.0;
  for (std::size_t i = 0; i < nlp_.elements.size(); ++i) f += gather(i, x).evaluate(local_x_, local_rows_);
  return std::isfinite(f);
}

bool IpoptProgram::eval_grad_f(Ipopt::Index n, const Ipopt::Number* x, bool, Ipopt::Number* gradient)
{
  std::fill_n(gradient, n, 0.0);
  for (std::size_t i = 0; i < nlp_.elements.size(); ++i)
  {
    const NlpElement::Derivatives& d = differentiate(i, x, 0.0, nullptr);
    const std::vector<int>& variables = nlp_.elements[i]->variables;
    for (std::size_t j = 0; j < variables.size(); ++j)
      gradient[variables[j]] += d.gradient[static_cast<Eigen::Index>(j)];
  }
  return std::all_of(gradient, gradient + n, [](double value) { return std::isfinite(value); });
}

bool IpoptProgram::eval_g(Ipopt::Index, const Ipopt::Number* x, bool, Ipopt::Index m, Ipopt::Number* g)
{
  for (std::size_t i = 0; i < nlp_.elements.size(); ++i)
  {
    gather(i, x).evaluate(local_x_, local_rows_);
    std::copy_n(local_rows_.data(), local_rows_.size(), g + first_row_[i]);
  }
  return std::all_of(g, g + m, [](double value) { return std::isfinite(value); });
}

bool IpoptProgram::eval_jac_g(Ipopt::Index, const Ipopt::Number* x, bool, Ipopt::Index, Ipopt::Index entries,
                              Ipopt::Index* rows, Ipopt::Index* columns, Ipopt::Number* values)
{
  std::size_t entry = 0;
  for (std::size_t i = 0; i < nlp_.elements.size(); ++i)
  {
    const NlpElement& element = *nlp_.elements[i];
    if (values) differentiate(i, x, 0.0, nullptr);
    for_entries(element.jacobian_pattern, [&](Eigen::Index row, Eigen::Index column) {
      if (values)
        values[entry] = derivatives_.jacobian(row, column);
      else
      {
        rows[entry] = first_row_[i] + static_cast<int>(row);
        columns[entry] = element.variables[static_cast<std::size_t>(column)];
      }
      ++entry;
    });
  }
  return !values || std::all_of(values, values + entries, [](double value) { return std::isfinite(value); });
}

bool IpoptProgram::eval_h(Ipopt::Index, const Ipopt::Number* x, bool, Ipopt::Number s, Ipopt::Index,
                          const Ipopt::Number* y, bool, Ipopt::Index entries, Ipopt::Index* rows, Ipopt::Index* columns,
                          Ipopt::Number* values)
{
  std::size_t entry = 0;
  for (std::size_t i = 0; i < nlp_.elements.size(); ++i)
  {
    const NlpElement& element = *nlp_.elements[i];
    if (values) differentiate(i, x, s, y);
    for_triangle(element.hessian_pattern, [&](Eigen::Index row, Eigen::Index column) {
      if (values)
        values[entry] = derivatives_.hessian(row, column);
      else
      {
        rows[entry] = element.variables[static_cast<std::size_t>(row)];
        columns[entry] = element.variables[static_cast<std::size_t>(column)];
        if (rows[entry] < columns[entry]) std::swap(rows[entry], columns[entry]);
      }
      ++entry;
    });
  }
  return !values || std::all_of(values, values + entries, [](double value) { return std::isfinite(value); });
}

bool IpoptProgram::intermediate_callback(Ipopt::AlgorithmMode, Ipopt::Index iteration, Ipopt::Number, Ipopt::Number,
                                         Ipopt::Number, Ipopt::Number, Ipopt::Number, Ipopt::Number, Ipopt::Number,
                                         Ipopt::Number, Ipopt::Index, const Ipopt::IpoptData*,
                                         Ipopt::IpoptCalculatedQuantities*)
{
  iterations_ = iteration;
  return !interrupt_.cancelled() && !interrupt_.timed_out();
}

void IpoptProgram::finalize_solution(Ipopt::SolverReturn, Ipopt::Index n, const Ipopt::Number* x, const Ipopt::Number*,
                                     const Ipopt::Number*, Ipopt::Index, const Ipopt::Number*, const Ipopt::Number*,
                                     Ipopt::Number, const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*)
{
  x_.assign(x, x + n);
}

}  // namespace fourwis
