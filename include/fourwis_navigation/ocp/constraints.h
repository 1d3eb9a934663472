#pragma once

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/ocp/problem.h"

namespace fourwis::ocp
{

/// The constraints of a problem as the interior point sees them: bounds and rows relaxed by 1e-8 (relative above 1), so
/// that there is an interior where bounds coincide or constraints leave one point only.
template <int NX, int NU>
struct Constraints
{
  std::vector<Bounds<NX, NU>> bounds;  ///< N + 1; infinite for what is fixed: x_0, fixed components of x_N, "u_N"
  std::vector<RowLimit> rows;
  std::vector<std::size_t> first_row;  ///< N + 2: stage k has the rows first_row[k] .. first_row[k + 1] - 1
  Vector<NX> initial_state;
  Vector<NX> goal;
  std::array<bool, static_cast<std::size_t>(NX)> fixed;  ///< components of x_N

  std::size_t intervals() const { return bounds.size() - 1; }

  bool is_fixed(int i) const { return fixed[static_cast<std::size_t>(i)]; }

  /// Whether component i of x_k is given, not found.
  bool is_given(std::size_t k, int i) const { return k == 0 || (k == intervals() && is_fixed(i)); }

  void set(const Problem<NX, NU>& problem);

private:
  void unbind(std::size_t k, int i)
  {
    bounds[k].lower[i] = -kInfinity;
    bounds[k].upper[i] = kInfinity;
  }
};

namespace detail
{

constexpr double kRelaxation = 1e-8;

inline double relaxation(double limit)
{
  return std::isfinite(limit) ? kRelaxation * std::max(1.0, std::abs(limit)) : 0.0;
}

}  // namespace detail

template <int NX, int NU>
void Constraints<NX, NU>::set(const Problem<NX, NU>& problem)
{
  initial_state = problem.initial_state;
  goal = problem.terminal_state;
  fixed = problem.terminal_fixed;
  bounds = problem.bounds;
  for (Bounds<NX, NU>& bound : bounds)
  {
    bound.lower -= bound.lower.unaryExpr(&detail::relaxation);
    bound.upper += bound.upper.unaryExpr(&detail::relaxation);
  }
  const std::size_t last = intervals();
  for (int i = 0; i < NX; ++i)
    for (const std::size_t k : {std::size_t{0}, last})
      if (is_given(k, i)) unbind(k, i);
  for (int i = NX; i < NX + NU; ++i) unbind(last, i);

  rows = problem.rows;
  for (RowLimit& row : rows) row.upper += detail::relaxation(row.upper);
  first_row.assign(1, 0);
  for (const int count : problem.row_counts) first_row.push_back(first_row.back() + static_cast<std::size_t>(count));
}

/// Whether sizes fit, given states are finite, lower <= upper, weights are positive, and row limits are finite. Each stage
/// but the last has at least `wide_rows` rows.
template <int NX, int NU>
bool is_valid(const Problem<NX, NU>& problem, int wide_rows = 0)
{
  if (problem.bounds.size() < 2 || problem.row_counts.size() != problem.bounds.size()) return false;
  if (!problem.initial_state.allFinite()) return false;
  for (int i = 0; i < NX; ++i)
    if (problem.terminal_fixed[static_cast<std::size_t>(i)] && !std::isfinite(problem.terminal_state[i])) return false;
  for (const Bounds<NX, NU>& bound : problem.bounds)
    if (!((bound.lower.array() <= bound.upper.array()) && (bound.lower.array() < kInfinity) &&
          (bound.upper.array() > -kInfinity))
             .all())
      return false;
  std::size_t rows = 0;
  for (std::size_t k = 0; k < problem.row_counts.size(); ++k)
  {
    const int count = problem.row_counts[k];
    if (count < (k + 1 < problem.row_counts.size() ? wide_rows : 0)) return false;
    rows += static_cast<std::size_t>(count);
  }
  return rows == problem.rows.size() && std::all_of(problem.rows.begin(), problem.rows.end(), [](const RowLimit& row) {
           return std::isfinite(row.upper) && row.weight > 0.0;
         });
}

template <int NX, int NU>
bool has_size(const Trajectory<NX, NU>& trajectory, std::size_t intervals)
{
  return trajectory.states.size() == intervals + 1 && trajectory.controls.size() == intervals;
}

template <int NX, int NU>
bool has_size(const Multipliers<NX, NU>& multipliers, const Problem<NX, NU>& problem)
{
  return multipliers.dynamics.size() + 1 == problem.bounds.size() &&
         multipliers.lower.size() == problem.bounds.size() && multipliers.upper.size() == problem.bounds.size() &&
         multipliers.rows.size() == problem.rows.size();
}

template <int NX, int NU>
bool is_finite(const Trajectory<NX, NU>& trajectory)
{
  const auto finite = [](const auto& vector) { return vector.allFinite(); };
  return std::all_of(trajectory.states.begin(), trajectory.states.end(), finite) &&
         std::all_of(trajectory.controls.begin(), trajectory.controls.end(), finite);
}

}  // namespace fourwis::ocp
