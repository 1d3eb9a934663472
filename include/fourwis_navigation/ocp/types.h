#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace fourwis::ocp
{

template <int Rows>
using Vector = Eigen::Matrix<double, Rows, 1>;
template <int Rows, int Columns>
using Matrix = Eigen::Matrix<double, Rows, Columns>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// States x_0..x_N and controls u_0..u_{N-1}.
template <int NX, int NU>
struct Trajectory
{
  std::vector<Vector<NX>> states;    ///< N + 1
  std::vector<Vector<NU>> controls;  ///< N
};

/// Lagrange multipliers. Those of bounds and rows are not negative; a bound of infinity has 0.
template <int NX, int NU>
struct Multipliers
{
  std::vector<Vector<NX>> dynamics;    ///< N: lambda_{k+1} of F_k(x_k, u_k) - x_{k+1} = 0
  Vector<NX> terminal;                 ///< nu of x_N - goal = 0; 0 where x_N is free
  std::vector<Vector<NX + NU>> lower;  ///< N + 1: of lower - (x_k, u_k) <= 0
  std::vector<Vector<NX + NU>> upper;  ///< N + 1: of (x_k, u_k) - upper <= 0
  std::vector<double> rows;            ///< of g_i - c_i <= 0, in the order of Problem::rows

  void resize(std::size_t intervals, std::size_t row_count)
  {
    dynamics.resize(intervals);
    lower.resize(intervals + 1);
    upper.resize(intervals + 1);
    rows.resize(row_count);
  }
};

}  // namespace fourwis::ocp
