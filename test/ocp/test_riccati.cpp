// The Riccati recursion against dense linear algebra.

#include "fourwis_navigation/ocp/riccati.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "fourwis_navigation/ocp/iterate.h"
#include "random_problem.h"

namespace fourwis::ocp
{
namespace
{

constexpr int NX = 3, NU = 2, NZ = NX + NU;
constexpr std::size_t kIntervals = 7;
constexpr Eigen::Index kControls = NU * kIntervals;  ///< of all intervals

/// Where the controls of an interval begin among all.
Eigen::Index first_control(std::size_t k)
{
  return static_cast<Eigen::Index>(k) * NU;
}

using Stages = Riccati<NX, NU>::Stages;
using Step = std::vector<StageVariables<NX, NU>>;

/// Hessians with eigenvalues of both signs, to whose diagonal `convexity` is added.
Stages random_stages(double convexity, Random& random)
{
  Stages stages(kIntervals + 1);
  for (auto& stage : stages)
  {
    const Matrix<NZ, NZ> half = random_matrix<NZ, NZ>(random);
    stage.hessian = half + half.transpose() + convexity * Matrix<NZ, NZ>::Identity();
    stage.jacobian_transposed = random_matrix<NZ, NX>(random);
    stage.gradient = random_matrix<NZ, 1>(random);
    stage.defect = random_matrix<NX, 1>(random);
  }
  return stages;
}

/// All dx_k as functions of all du_k: dx_k = offset_k + response_k du.
struct Response
{
  std::vector<Eigen::MatrixXd> response;
  std::vector<Eigen::VectorXd> offset;

  explicit Response(const Stages& stages)
  {
    response.push_back(Eigen::MatrixXd::Zero(NX, kControls));
    offset.push_back(Eigen::VectorXd::Zero(NX));
    for (std::size_t k = 0; k < kIntervals; ++k)
    {
      const Matrix<NX, NZ> J = stages[k].jacobian_transposed.transpose();
      Eigen::MatrixXd next = J.leftCols<NX>() * response[k];
      next.middleCols<NU>(first_control(k)) += J.rightCols<NU>();
      response.push_back(next);
      offset.push_back(J.leftCols<NX>() * offset[k] + stages[k].defect);
    }
  }

  /// dz_k = matrix du + the offset.
  Eigen::MatrixXd of_stage(std::size_t k) const
  {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(NZ, kControls);
    matrix.topRows<NX>() = response[k];
    if (k < kIntervals) matrix.block<NU, NU>(NX, first_control(k)).setIdentity();
    return matrix;
  }

  Vector<NZ> offset_of_stage(std::size_t k) const
  {
    Vector<NZ> z = Vector<NZ>::Zero();
    z.head<NX>() = offset[k];
    return z;
  }
};

/// Hessian and gradient at du = 0 of the cost as a function of the controls alone.
struct Condensed
{
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(kControls, kControls);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(kControls);

  explicit Condensed(const Stages& stages)
  {
    const Response response(stages);
    for (std::size_t k = 0; k <= kIntervals; ++k)
    {
      const Eigen::MatrixXd T = response.of_stage(k);
      hessian += T.transpose() * stages[k].hessian * T;
      gradient += T.transpose() * (stages[k].hessian * response.offset_of_stage(k) + stages[k].gradient);
    }
  }
};

TEST(Riccati, EqualsTheDenseSolutionOfTheCondensedProblem)
{
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Stages stages = random_stages(5.0, random);
    Riccati<NX, NU> riccati;
    riccati.resize(stages.size());
    ASSERT_TRUE(riccati.factorize(stages, 0.0));
    Step step(stages.size());
    riccati.solve(stages, step);

    const Condensed condensed(stages);
    const Eigen::VectorXd du = condensed.hessian.fullPivLu().solve(-condensed.gradient);
    for (std::size_t k = 0; k < kIntervals; ++k)
      EXPECT_LT((step[k].z.tail<NU>() - du.segment<NU>(first_control(k))).norm(), 1e-10);
  }
}

TEST(Riccati, StepSatisfiesDynamicsAndStationarity)
{
  Random random(1);
  const Stages stages = random_stages(5.0, random);
  Riccati<NX, NU> riccati;
  riccati.resize(stages.size());
  ASSERT_TRUE(riccati.factorize(stages, 0.0));
  Step step(stages.size());
  riccati.solve(stages, step);
  EXPECT_EQ(step[0].z.head<NX>(), Vector<NX>::Zero());
  for (std::size_t k = 0; k <= kIntervals; ++k)
  {
    SCOPED_TRACE(testing::Message() << "stage " << k);
    Vector<NZ> gradient = stages[k].hessian * step[k].z + stages[k].gradient;
    gradient.head<NX>() -= step[k].lambda;
    if (k < kIntervals) gradient += stages[k].jacobian_transposed * step[k + 1].lambda;
    EXPECT_LT((k < kIntervals ? gradient.norm() : gradient.head<NX>().norm()), 1e-10);
    if (k == kIntervals) break;
    const Vector<NX> next = stages[k].jacobian_transposed.transpose() * step[k].z + stages[k].defect;
    EXPECT_LT((next - step[k + 1].z.head<NX>()).norm(), 1e-10);
  }
}

TEST(Riccati, FactorisesExactlyTheProblemsThatHaveAMinimum)
{
  int convex = 0;
  for (unsigned seed = 0; seed < 500; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const double regularization = 0.5 + 0.5 * random.unit();
    Stages stages = random_stages(2.0 + 2.0 * random.unit(), random);
    Riccati<NX, NU> riccati;
    riccati.resize(stages.size());
    const bool factorized = riccati.factorize(stages, regularization);
    for (auto& stage : stages) stage.hessian.diagonal().array() += regularization;
    const Eigen::VectorXd curvatures =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Condensed(stages).hessian).eigenvalues();
    EXPECT_EQ(factorized, curvatures.minCoeff() > 0.0) << curvatures.minCoeff();
    convex += factorized;
  }
  EXPECT_GT(convex, 100);
  EXPECT_LT(convex, 400);
}

TEST(Riccati, RefusesNumbersThatAreNotFinite)
{
  Random random(2);
  Stages stages = random_stages(5.0, random);
  stages[3].hessian(NX, NX) = std::nan("");
  Riccati<NX, NU> riccati;
  riccati.resize(stages.size());
  EXPECT_FALSE(riccati.factorize(stages, 0.0));
}

}  // namespace
}  // namespace fourwis::ocp
