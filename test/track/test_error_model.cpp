#include "track/error_model.h"

#include <gtest/gtest.h>

#include "../support/random.h"
#include "fourwis_navigation/vehicle/wheels.h"
#include "track/roll_out.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 42;

struct Situation
{
  Mode mode;
  ReferencePoint reference;
  ErrorState error;
  ErrorInput input;
};

Situation random_situation(Random& random, const Robot& robot, double size)
{
  Situation s;
  s.mode = random.chance(0.2) ? Mode::spin : random.mode();
  s.reference.state = {random.pose(5.0), random.between(-1.0, 1.0),
                       s.mode == Mode::spin ? 0.0 : random.steering(robot, s.mode)};
  s.reference.input = {random.between(-5.0, 5.0), s.mode == Mode::spin ? 0.0 : random.between(-2.0, 2.0)};
  for (double& value : s.error) value = random.between(-size, size);
  for (double& value : s.input) value = random.between(-size, size);
  if (s.mode == Mode::spin) s.error[4] = s.input[1] = 0.0;
  return s;
}

/// The state with the error of the situation.
MotionState displaced(const ErrorModel& model, const Situation& s)
{
  return {model.pose(s.error, s.reference.state), s.reference.state.v + s.error[3], s.reference.state.phi + s.error[4]};
}

TEST(ErrorModel, PoseIsTheInverseOfError)
{
  const Robot robot;
  Random random(kSeed);
  for (int trial = 0; trial < 200; ++trial)
  {
    const Situation s = random_situation(random, robot, 0.3);
    const ErrorModel model(robot, s.mode);
    EXPECT_LT((model.error(displaced(model, s), s.reference.state) - s.error).norm(), 1e-12);
  }
}

/// Rolls out the robot and the reference a little, and returns how their difference changes.
TEST(ErrorModel, RateIsThatOfTheKinematics)
{
  const Robot robot;
  Random random(kSeed);
  constexpr double h = 1e-5;
  for (int trial = 0; trial < 200; ++trial)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const Situation s = random_situation(random, robot, 0.3);
    const ErrorModel model(robot, s.mode);
    const MotionInput& u = s.reference.input;
    const MotionState real = roll_out(robot, s.mode, displaced(model, s), {u.a + s.input[0], u.omega + s.input[1]}, h);
    const MotionState reference = roll_out(robot, s.mode, s.reference.state, u, h);
    const ErrorState change = (model.error(real, reference) - s.error) / h;
    EXPECT_LT((change - model.rate(s.error, s.input, s.reference)).norm(), 2e-4);
  }
}

TEST(ErrorModel, JacobianIsTheDerivativeOfTheRateIntegrated)
{
  const Robot robot;
  Random random(kSeed);
  for (int trial = 0; trial < 200; ++trial)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const Situation s = random_situation(random, robot, 1e-6);
    const ErrorModel model(robot, s.mode);
    constexpr double h = 0.04;
    constexpr int steps = 400;
    ErrorState error = s.error;
    for (int i = 0; i < steps; ++i)
    {
      const ErrorState middle = error + 0.5 * h / steps * model.rate(error, s.input, s.reference);
      error += h / steps * model.rate(middle, s.input, s.reference);
    }
    Eigen::Matrix<double, 7, 1> z;
    z << s.error, s.input;
    EXPECT_LT((model.jacobian(s.reference, h) * z - error).norm(), 2e-5 * z.norm());
  }
}

TEST(ErrorModel, SteeringGainIsThatOfTheFastestWheel)
{
  const Robot robot;
  Random random(kSeed);
  for (int trial = 0; trial < 200; ++trial)
  {
    const Mode mode = random.mode();
    const double phi = random.steering(robot, mode), h = 1e-6;
    const WheelAngles before = wheel_angles(robot, mode, phi - h), after = wheel_angles(robot, mode, phi + h);
    double greatest = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i)
      greatest = std::max(greatest, std::abs(wrap_angle(after[i] - before[i])) / (2.0 * h));
    EXPECT_NEAR(ErrorModel(robot, mode).steering_gain(phi), greatest, 1e-6);
  }
}

}  // namespace
}  // namespace fourwis
