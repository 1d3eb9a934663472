#pragma once

#include <cmath>

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
///   [S_xx S_xu; S_ux S_uu] = H_k + J_k' P_{k+1} J_k,   S_uu = L L',   Y = L^-1 S_ux,
///   K_k = -L^-T Y,                                     P_k = S_xx - Y' Y,
///   [s_x; s_u] = h_k + J_k' (p_{k+1} + P_{k+1} c_k),
///   d_k = -L^-T L^-1 s_u,                              p_k = s_x + K_k' s_u,
///   du_k = K_k dx_k + d_k,                             lambda_k = P_k dx_k + p_k.
/// The first two lines depend on the matrices only: they are factorised once, and solved for several h and c.
template <int NX, int NU>
class Riccati
{
public:
  using Stages = std::vector<QuadraticStage<NX, NU>>;

  void resize(std::size_t stage_count) { stages_.resize(stage_count); }

  /// Whether the problem with `regularization` added to the diagonal of each H_k has one minimum: all S_uu are positive
  /// definite. If not, `solve` must not be called.
  bool factorize(const Stages& problem, double regularization);

  /// Writes dz_k and lambda_k to `step[k].z` and `step[k].lambda`; the last du is 0.
  template <class StepStages>
  void solve(const Stages& problem, StepStages& step);

private:
  static constexpr int NZ = NX + NU;
  struct Stage
  {
    Matrix<NX, NX> P;
    Vector<NX> p;
    Matrix<NU, NX> K;
    Vector<NU> d;
    Matrix<NU, NU> inverse_L;
  };

  static bool eliminate_controls(const Matrix<NZ, NZ>& S, Stage& stage);
  void sweep_back(const Stages& problem);

  std::vector<Stage> stages_;
};

// Products of such small matrices are evaluated coefficient by coefficient (lazyProduct): Eigen's choice for large
// ones, to which 8 x 5 already belongs, spends its time on packing.

template <int NX, int NU>
bool Riccati<NX, NU>::factorize(const Stages& problem, double regularization)
{
  const std::size_t last = problem.size() - 1;
  stages_[last].P = problem[last].hessian.template topLeftCorner<NX, NX>();
  stages_[last].P.diagonal().array() += regularization;
  for (std::size_t k = last; k-- > 0;)
  {
    const Matrix<NZ, NX>& Jt = problem[k].jacobian_transposed;
    const Matrix<NZ, NX> JtP = Jt.lazyProduct(stages_[k + 1].P);
    Matrix<NZ, NZ> S = problem[k].hessian + JtP.lazyProduct(Jt.transpose());
    S.diagonal().array() += regularization;
    if (!eliminate_controls(S, stages_[k])) return false;
  }
  return true;
}

namespace detail
{

/// L^-1 of a symmetric matrix A = L L', by rows of L; false if A is not safely positive definite.
template <int N>
bool inverse_cholesky(const Matrix<N, N>& A, Matrix<N, N>& inverse_L)
{
  constexpr double least_pivot = 1e-11;
  Matrix<N, N> L;
  inverse_L.setZero();
  for (int i = 0; i < N; ++i)
  {
    double pivot = A(i, i);
    for (int j = 0; j < i; ++j)
    {
      L(i, j) = A(i, j);
      for (int m = 0; m < j; ++m) L(i, j) -= L(i, m) * L(j, m);
      L(i, j) *= inverse_L(j, j);
      pivot -= L(i, j) * L(i, j);
    }
    if (!(pivot > least_pivot && pivot < kInfinity)) return false;
    inverse_L(i, i) = 1.0 / std::sqrt(pivot);
    for (int j = 0; j < i; ++j)
      for (int m = j; m < i; ++m) inverse_L(i, j) -= inverse_L(i, i) * L(i, m) * inverse_L(m, j);
  }
  return true;
}

}  // namespace detail

/// L^-1, K and P of a stage.
template <int NX, int NU>
bool Riccati<NX, NU>::eliminate_controls(const Matrix<NZ, NZ>& S, Stage& stage)
{
  if (!detail::inverse_cholesky<NU>(S.template bottomRightCorner<NU, NU>(), stage.inverse_L)) return false;
  const Matrix<NU, NX> Y = stage.inverse_L.lazyProduct(S.template bottomLeftCorner<NU, NX>());
  stage.K = -stage.inverse_L.transpose().lazyProduct(Y);
  stage.P = S.template topLeftCorner<NX, NX>() - Y.transpose().lazyProduct(Y);
  stage.P.template triangularView<Eigen::StrictlyUpper>() = stage.P.transpose();  // rounding must not add up
  return true;
}

template <int NX, int NU>
void Riccati<NX, NU>::sweep_back(const Stages& problem)
{
  const std::size_t last = problem.size() - 1;
  stages_[last].p = problem[last].gradient.template head<NX>();
  for (std::size_t k = last; k-- > 0;)
  {
    Stage& stage = stages_[k];
    const Vector<NX> r = stages_[k + 1].p + stages_[k + 1].P.lazyProduct(problem[k].defect);
    const Vector<NZ> s = problem[k].gradient + problem[k].jacobian_transposed.lazyProduct(r);
    const Vector<NU> s_u = s.template tail<NU>();
    const Vector<NU> y = stage.inverse_L.lazyProduct(s_u);
    stage.d = -stage.inverse_L.transpose().lazyProduct(y);
    stage.p = s.template head<NX>() + stage.K.transpose().lazyProduct(s_u);
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
    Vector<NU> du = Vector<NU>::Zero();
    if (k < last) du = stage.d + stage.K.lazyProduct(dx);
    step[k].z.template head<NX>() = dx;
    step[k].z.template tail<NU>() = du;
    step[k].lambda = stage.p + stage.P.lazyProduct(dx);
    if (k < last) dx = problem[k].defect + problem[k].jacobian_transposed.transpose().lazyProduct(step[k].z);
  }
}

}  // namespace fourwis::ocp
