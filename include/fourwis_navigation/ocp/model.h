#pragma once

#include "fourwis_navigation/ocp/types.h"

namespace fourwis::ocp
{

/// Values of stage k < N at (x_k, u_k) and x_{k+1}.
template <int NX>
struct StageValue
{
  double cost;        ///< l_k(x_k, u_k)
  Vector<NX> defect;  ///< F_k(x_k, u_k) - x_{k+1}
};

/// Derivatives of stage k < N with respect to z = (x_k, u_k).
template <int NX, int NU>
struct StageDerivatives
{
  Matrix<NX, NX + NU> jacobian;      ///< dF_k/dz
  Vector<NX + NU> gradient;          ///< dl_k/dz
  Matrix<NX + NU, NX + NU> hessian;  ///< d2/dz2 of l_k + lambda' F_k, both triangles
};

/// Derivatives of the terminal cost l_N with respect to x_N.
template <int NX>
struct TerminalDerivatives
{
  Vector<NX> gradient;
  Matrix<NX, NX> hessian;
};

/// Views of the rows of one stage, one entry (of `gradients`: one column) each.
using RowValues = Eigen::Map<Eigen::VectorXd>;
using RowMultipliers = Eigen::Map<const Eigen::VectorXd>;
template <int NR>
using RowGradients = Eigen::Map<Eigen::Matrix<double, NR, Eigen::Dynamic>>;

/// What every model of an optimal-control problem derives from: its sizes, the types of its functions, and the
/// functions of a problem without terminal cost and without rows. Nothing is virtual: the solver is a template of the
/// model, so a model declares anew what it has.
///
/// A model must have, for 0 <= k < N,
///   void evaluate(std::size_t k, const State& x, const Control& u, const State& next, Value& value) const;
///   void differentiate(std::size_t k, const State& x, const Control& u, const State& lambda, Derivatives& derivatives) const;
/// where the dynamics are given as their defect F_k(x, u) - next (so that an angle may be wrapped there), and may have
///   double terminal_cost(const State& x) const;
///   void differentiate_terminal(const State& x, Terminal& terminal) const;
///   void rows(std::size_t k, const RowPoint& q, RowValues values) const;
///   void differentiate_rows(std::size_t k, const RowPoint& q, RowMultipliers y, Gradients gradients,
///                           RowHessian& hessian) const;
/// for the rows g_i(q) of stages 0 <= k <= N with rows, q being the first NR components of (x_k, u_k),
/// `gradients.col(i)` = dg_i/dq and `hessian` = sum_i y_i d2g_i/dq2. At k = N the controls in q are 0 and must not
/// matter. With NW > 0, q is all of (x_k, u_k), and the first NW rows of each stage k < N, which must exist, depend on all of
/// it, the others still on the first NR components only: many rows of few variables stay cheap beside few of many.
///
/// Every derivative is zero before the call: only what differs from zero must be written. Functions must not keep state
/// between calls. Values that are not finite reject a step; they are no error.
template <int NX, int NU, int NR = NX, int NW = 0>
struct ModelBase
{
  static_assert(NX >= 1 && NU >= 1 && NR >= 1 && NR <= NX + NU, "rows are functions of leading components of (x, u)");

  static constexpr int kStates = NX;
  static constexpr int kControls = NU;
  static constexpr int kRowVariables = NR;
  static constexpr int kWideRows = NW;
  static constexpr int kRowPoint = NW > 0 ? NX + NU : NR;  ///< size of q

  using State = Vector<NX>;
  using Control = Vector<NU>;
  using Value = StageValue<NX>;
  using Derivatives = StageDerivatives<NX, NU>;
  using Terminal = TerminalDerivatives<NX>;
  using RowPoint = Vector<kRowPoint>;
  using Gradients = RowGradients<kRowPoint>;
  using RowHessian = Matrix<kRowPoint, kRowPoint>;

  double terminal_cost(const State&) const { return 0.0; }
  void differentiate_terminal(const State&, Terminal&) const {}
  void rows(std::size_t, const RowPoint&, RowValues) const {}
  void differentiate_rows(std::size_t, const RowPoint&, RowMultipliers, Gradients, RowHessian&) const {}
};

}  // namespace fourwis::ocp
