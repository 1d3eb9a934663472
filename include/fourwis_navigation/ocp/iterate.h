#pragma once

#include "fourwis_navigation/ocp/types.h"

namespace fourwis::ocp
{

/// Variables of stage k. At k = N the controls are 0 and stay so.
template <int NX, int NU>
struct StageVariables
{
  Vector<NX + NU> z;      ///< (x_k, u_k)
  Vector<NX> lambda;      ///< multiplier of the dynamics that end in x_k
  Vector<NX + NU> lower;  ///< multipliers of the bounds; 0 where there is none
  Vector<NX + NU> upper;
};

/// Variables of the row g - c - e + t = 0 with t, e > 0. Stationarity in t and e is kept exactly: t's multiplier is y,
/// and e's is the weight less y. In a hard row e = 0 and e's multiplier is infinite.
struct RowVariables
{
  double slack;              ///< t
  double excess;             ///< e
  double multiplier;         ///< y
  double excess_multiplier;  ///< weight - y
};

/// A point of the primal-dual method, or a step between two of them.
template <int NX, int NU>
struct Iterate
{
  std::vector<StageVariables<NX, NU>> stages;  ///< N + 1
  std::vector<RowVariables> rows;
  Vector<NX> nu;  ///< multipliers of the terminal condition

  void resize(std::size_t stage_count, std::size_t row_count)
  {
    stages.resize(stage_count);
    rows.resize(row_count);
  }
};

/// What should be zero: the equalities at an iterate.
template <int NX>
struct Residuals
{
  std::vector<Vector<NX>> defects;  ///< N: F_k(x_k, u_k) - x_{k+1}
  Vector<NX> terminal;              ///< x_N - goal; 0 where x_N is free
  std::vector<double> rows;         ///< g_i - c_i - e_i + t_i
};

}  // namespace fourwis::ocp
