#include "fourwis_navigation/optimize/simpson.h"

#include <gtest/gtest.h>

#include "../support/random.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 20240607;
using State = SimpsonDynamics::State;
using Control = SimpsonDynamics::Control;

struct Sample
{
  State x;
  Control u;
  State lambda;
};

Sample random_sample(Random& random)
{
  Sample sample;
  sample.x << 3 * random.unit(), 3 * random.unit(), 4 * random.unit(), random.unit(), 0.3 * random.unit();
  sample.u << 5 * random.unit(), 0.8 * random.unit(), 0.15 + 0.1 * random.unit();
  for (int i = 0; i < 5; ++i) sample.lambda[i] = random.unit();
  return sample;
}

class Simpson : public testing::TestWithParam<Mode>
{
protected:
  const Robot robot_;
  const SimpsonDynamics dynamics_{robot_, GetParam()};
};

TEST_P(Simpson, MeetsAFineIntegrationOfTheBodyTwist)
{
  Random random(kSeed);
  for (int trial = 0; trial < 200; ++trial)
  {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " trial " << trial);
    const Sample sample = random_sample(random);
    const int steps = 20000;
    Pose pose = {sample.x[0], sample.x[1], sample.x[2]};
    const double dt = sample.u[2] / steps;
    for (int i = 0; i < steps; ++i)
    {
      const double t = (i + 0.5) * dt;
      const double v = sample.x[3] + sample.u[0] * t, phi = sample.x[4] + sample.u[1] * t;
      pose = advance(robot_, pose, GetParam(), phi, v * dt);
    }
    const State next = dynamics_.next(sample.x, sample.u);
    EXPECT_NEAR(next[0], pose.x, 3e-3);
    EXPECT_NEAR(next[1], pose.y, 3e-3);
    EXPECT_NEAR(next[2], pose.theta, 6e-3);
    EXPECT_DOUBLE_EQ(next[3], sample.x[3] + sample.u[0] * sample.u[2]);
    EXPECT_DOUBLE_EQ(next[4], sample.x[4] + sample.u[1] * sample.u[2]);
  }
}

TEST_P(Simpson, ErrorFallsWithTheFourthPowerOfTheIntervalOrFaster)
{
  State x;
  x << 0.0, 0.0, 0.3, 0.8, 0.2;
  const auto error = [&](double h) {
    Control u;
    u << 0.5, 0.4, h;
    State fine = x;
    Control step = u;
    step[2] = h / 64;
    for (int i = 0; i < 64; ++i) fine = dynamics_.next(fine, step);
    return (dynamics_.next(x, u) - fine).norm();
  };
  EXPECT_LT(error(0.2), error(0.4) / 16.0 + 1e-13);
}

TEST_P(Simpson, JacobianMeetsDifferences)
{
  Random random(kSeed);
  for (int trial = 0; trial < 100; ++trial)
  {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " trial " << trial);
    const Sample sample = random_sample(random);
    SimpsonDynamics::Jacobian jacobian;
    SimpsonDynamics::Hessian hessian = SimpsonDynamics::Hessian::Zero();
    dynamics_.differentiate(sample.x, sample.u, sample.lambda, jacobian, hessian);
    for (int i = 0; i < 8; ++i)
    {
      const double step = 1e-6;
      State x_up = sample.x, x_down = sample.x;
      Control u_up = sample.u, u_down = sample.u;
      (i < 5 ? x_up[i] : u_up[i - 5]) += step;
      (i < 5 ? x_down[i] : u_down[i - 5]) -= step;
      const State difference = (dynamics_.next(x_up, u_up) - dynamics_.next(x_down, u_down)) / (2 * step);
      EXPECT_LT((difference - jacobian.col(i)).cwiseAbs().maxCoeff(), 1e-8) << "variable " << i;
    }
  }
}

TEST_P(Simpson, HessianMeetsDifferencesOfTheJacobian)
{
  Random random(kSeed + 1);
  for (int trial = 0; trial < 100; ++trial)
  {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed + 1 << " trial " << trial);
    const Sample sample = random_sample(random);
    SimpsonDynamics::Jacobian jacobian;
    SimpsonDynamics::Hessian hessian = SimpsonDynamics::Hessian::Zero();
    dynamics_.differentiate(sample.x, sample.u, sample.lambda, jacobian, hessian);
    const auto gradient = [&](const State& x, const Control& u) {
      SimpsonDynamics::Jacobian j;
      SimpsonDynamics::Hessian unused = SimpsonDynamics::Hessian::Zero();
      dynamics_.differentiate(x, u, sample.lambda, j, unused);
      return (j.transpose() * sample.lambda).eval();
    };
    for (int i = 0; i < 8; ++i)
    {
      const double step = 1e-6;
      State x_up = sample.x, x_down = sample.x;
      Control u_up = sample.u, u_down = sample.u;
      (i < 5 ? x_up[i] : u_up[i - 5]) += step;
      (i < 5 ? x_down[i] : u_down[i - 5]) -= step;
      const auto difference = ((gradient(x_up, u_up) - gradient(x_down, u_down)) / (2 * step)).eval();
      EXPECT_LT((difference - hessian.col(i)).cwiseAbs().maxCoeff(), 1e-7) << "variable " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, Simpson, testing::ValuesIn(kPlannedModes),
                         [](const auto& given) { return std::string(to_string(given.param)); });

}  // namespace
}  // namespace fourwis
