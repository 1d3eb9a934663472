#pragma once

#include <array>
#include <vector>

#include "fourwis_navigation/ocp/types.h"

namespace fourwis::ocp
{

/// lower <= (x_k, u_k) <= upper, states first; +-infinity where there is no bound. Kept to 1e-8 (relative above 1).
template <int NX, int NU>
struct Bounds
{
  Vector<NX + NU> lower = Vector<NX + NU>::Constant(-kInfinity);
  Vector<NX + NU> upper = Vector<NX + NU>::Constant(kInfinity);
};

/// g_i <= upper. With a finite weight the row may be exceeded by e_i >= 0, which costs weight * e_i (an exact penalty:
/// as long as the row's multiplier stays below the weight, e_i = 0 at the solution). Infinite: a hard row.
struct RowLimit
{
  double upper;
  double weight = kInfinity;
};

/// The numbers of an optimal-control problem; its functions are the model's (model.h).
template <int NX, int NU>
struct Problem
{
  Vector<NX> initial_state = Vector<NX>::Zero();
  std::array<bool, static_cast<std::size_t>(NX)> terminal_fixed =
      {};  ///< which components of x_N equal those of `terminal_state`
  Vector<NX> terminal_state = Vector<NX>::Zero();
  std::vector<Bounds<NX, NU>> bounds;  ///< N + 1; not applied to x_0, fixed components of x_N and "u_N"
  std::vector<int> row_counts;         ///< N + 1: number of rows of each stage
  std::vector<RowLimit> rows;          ///< stage by stage

  /// N; the problem must have bounds.
  std::size_t intervals() const { return bounds.size() - 1; }

  /// N intervals without bounds, rows and terminal condition. Keeps the storage.
  void reset(std::size_t intervals)
  {
    terminal_fixed.fill(false);
    bounds.assign(intervals + 1, {});
    row_counts.assign(intervals + 1, 0);
    rows.clear();
  }

  /// Appends a row to stage k; stages must be filled in ascending order.
  void add_row(std::size_t k, const RowLimit& limit)
  {
    ++row_counts[k];
    rows.push_back(limit);
  }
};

}  // namespace fourwis::ocp
