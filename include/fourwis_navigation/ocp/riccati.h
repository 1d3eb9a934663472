#pragma once

#include <Eigen/Cholesky>

#include "fourwis_navigation/ocp/types.h"

namespace fourwis::ocp
{

/// One stage of the linear-quadratic problem in dz_k = (dx_k, du_k)
///   minimise  sum_k 1/2 dz_k' H_k dz_k + h_k' dz_k   subject to  dx_{k+1} = J_k dz_k + c_k,  dx_0 = 0.
/// Of the last stage only the leading part of H and h, which concerns dx_N, is used.
template <int NX, int NU>
struct QuadraticStage
{
  Matrix<NX + NU, NX> jacobian_transposed;  ///< J_k'
  Matrix<NX + NU, NX + NU> hessian;         ///< H_k, symmetric
  Vector<NX + NU> gradient;                 ///< h_k
  Vector<NX> defect;                        ///< c_k
};

/// Solves that problem by dynamic programming. With the value functions V_k(dx) = 1/2 dx' P_k dx + p_k' dx,
///   [S_xx S_xu; S_ux S_uu] = H_k + J_k' P_{k+1} J_k,   S_uu = L L',
///   K_k = -S_uu^-1 S_ux,                               P_k = S_xx + S_xu K_k,
///   [s_x; s_u] = h_k + J_k' (p_{k+1} + P_{k+1} c_k),
///   d_k = -S_uu^-1 s_u,                                p_k = s_x + K_k' s_u,
///   du_k = K_k dx_k + d_k,                             lambda_k = P_k dx_k + p_k.
/// The first two lines depend on the matrices only: they are factorised once, and solved for several h and c.
template <int NX, int NU>
class Riccati
{
public:
  using Stages = std::vector<QuadraticStage<NX, NU>>;

  void resize(std::size_t stage_count) { stages_.resize(stage_count); }

  /// Whether the problem with `regularization` added to the diagonal of each H_k has one minimum: all S_uu are positive
  /// definite. Without it `solve` must not be called.
  bool factorize(const Stages& problem, double regularization);

  /// Writes dz_k and lambda_k to `step.z` and `step.lambda`; the last du is 0.
  template <class StepStages>
  void solve(const Stages& problem, StepStages& step);

private:
  using StateMatrix = Matrix<NX, NX>;
  struct Stage
  {
    StateMatrix P;
    Vector<NX> p;
    Matrix<NU, NX> K;
    Vector<NU> d;
    Matrix<NU, NU> L;
  };

  static bool eliminate_controls(const Matrix<NX + NU, NX + NU>& S, Stage& stage);
  static void solve_controls(const Matrix<NU, NU>& L, Vector<NU>& s);
  void sweep_back(const Stages& problem);

  std::vector<Stage> stages_;
};

template <int NX, int NU>
bool Riccati<NX, NU>::factorize(const Stages& problem, double regularization)
{
  const std::size_t last = problem.size() - 1;
  stages_[last].P = problem[last].hessian.template topLeftCorner<NX, NX>();
  stages_[last].P.diagonal().array() += regularization;
  for (std::size_t k = last; k-- > 0;)
  {
    const auto& Jt = problem[k].jacobian_transposed;
    Matrix<NX + NU, NX> JtP;
    JtP.noalias() = Jt * stages_[k + 1].P;
    Matrix<NX + NU, NX + NU> S = problem[k].hessian;
    S.noalias() += JtP * Jt.transpose();
    S.diagonal().array() += regularization;
    if (!eliminate_controls(S, stages_[k])) return false;
  }
  return true;
}

/// L, K and P of a stage; false if S_uu is not safely positive definite.
template <int NX, int NU>
bool Riccati<NX, NU>::eliminate_controls(const Matrix<NX + NU, NX + NU>& S, Stage& stage)
{
  constexpr double least_pivot = 1e-11;
  const Eigen::LLT<Matrix<NU, NU>> cholesky(S.template bottomRightCorner<NU, NU>());
  stage.L = cholesky.matrixLLT();
  if (cholesky.info() != Eigen::Success || !(stage.L.diagonal().array().square() > least_pivot).all()) return false;
  Matrix<NU, NX> S_ux = S.template bottomLeftCorner<NU, NX>();
  for (int j = 0; j < NX; ++j)
  {
    Vector<NU> column = -S_ux.col(j);
    solve_controls(stage.L, column);
    stage.K.col(j) = column;
  }
  stage.P = S.template topLeftCorner<NX, NX>();
  stage.P.noalias() += S.template topRightCorner<NX, NU>() * stage.K;
  stage.P = 0.5 * (stage.P + stage.P.transpose()).eval();
  return true;
}

/// s <- S_uu^-1 s
template <int NX, int NU>
void Riccati<NX, NU>::solve_controls(const Matrix<NU, NU>& L, Vector<NU>& s)
{
  L.template triangularView<Eigen::Lower>().solveInPlace(s);
  L.template triangularView<Eigen::Lower>().transpose().solveInPlace(s);
}

template <int NX, int NU>
void Riccati<NX, NU>::sweep_back(const Stages& problem)
{
  const std::size_t last = problem.size() - 1;
  stages_[last].p = problem[last].gradient.template head<NX>();
  for (std::size_t k = last; k-- > 0;)
  {
    Stage& stage = stages_[k];
    Vector<NX> r = stages_[k + 1].p;
    r.noalias() += stages_[k + 1].P * problem[k].defect;
    Vector<NX + NU> s = problem[k].gradient;
    s.noalias() += problem[k].jacobian_transposed * r;
    stage.d = -s.template tail<NU>();
    solve_controls(stage.L, stage.d);
    stage.p = s.template head<NX>();
    stage.p.noalias() += stage.K.transpose() * s.template tail<NU>();
  }
}

template <int NX, int NU>
template <class StepStages>
void Riccati<NX, NU>::solve(const Stages& problem, StepStages& step)
{
  sweep_back(problem);
  const std::size_t last = problem.size() - 1;
  Vector<NX> dx = Vector<NX>::Zero();
  for (std::size_t k = 0; k <= last; ++k)
  {
    const Stage& stage = stages_[k];
    step[k].lambda = stage.p;
    step[k].lambda.noalias() += stage.P * dx;
    step[k].z.template head<NX>() = dx;
    step[k].z.template tail<NU>().setZero();
    if (k == last) break;
    Vector<NU> du = stage.d;
    du.noalias() += stage.K * dx;
    step[k].z.template tail<NU>() = du;
    dx = problem[k].defect;
    dx.noalias() += problem[k].jacobian_transposed.transpose() * step[k].z;
  }
}

}  // namespace fourwis::ocp
