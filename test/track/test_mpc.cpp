#include "track/mpc.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "fourwis_navigation/vehicle/wheels.h"
#include "random_stretch.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 43;

/// A random stretch, a time on it, and a robot beside the reference.
struct Scene
{
  Robot robot;
  TrackOptions options;
  Mode mode;
  Trajectory points;
  Reference reference;
  MotionState state;
  double t;

  Scene(Random& random, double size)
    : mode(random.mode()),
      points(random_stretch(random, robot, mode)),
      reference(robot, points.data(), points.data() + points.size()),
      t(random.between(0.0, 2.0))
  {
    state = reference.at(t).state;
    state.pose =
        compose(state.pose, {random.between(-size, size), random.between(-size, size), random.between(-size, size)});
    state.v += random.between(-size, size);
    state.phi += random.between(-size, size);
  }

  SteeringRange range() const
  {
    return mode == Mode::parallel ? SteeringRange{-2.0, 2.0}
                                  : SteeringRange{-robot.max_steering_angle, robot.max_steering_angle};
  }
};

/// Cost of the problem with these inputs.
double cost(const Mpc& mpc, const std::vector<ErrorInput>& inputs)
{
  const HorizonModel& model = mpc.horizon();
  ErrorState x = mpc.problem().initial_state;
  double sum = 0.0;
  for (std::size_t k = 0; k < inputs.size(); ++k)
  {
    HorizonModel::Value value;
    model.evaluate(k, x, inputs[k], ErrorState::Zero(), value);
    sum += value.cost;
    x = value.defect;
  }
  return sum + model.terminal_cost(x);
}

/// Whether the inputs keep the bounds.
bool is_feasible(const Mpc& mpc, const std::vector<ErrorInput>& inputs)
{
  ErrorState x = mpc.problem().initial_state;
  for (std::size_t k = 0; k < inputs.size(); ++k)
  {
    Eigen::Matrix<double, 7, 1> z;
    z << x, inputs[k];
    const auto& bounds = mpc.problem().bounds[k];
    const int first = k == 0 ? 5 : 0;  // the initial state is fixed
    if ((z - bounds.lower).tail(7 - first).minCoeff() < -1e-6) return false;
    if ((bounds.upper - z).tail(7 - first).minCoeff() < -1e-6) return false;
    x = mpc.horizon().intervals[k].jacobian * z;
  }
  return true;
}

TEST(Mpc, OnTheReferenceTheAnswerIsTheReference)
{
  Random random(kSeed);
  for (int trial = 0; trial < 100; ++trial)
  {
    const Scene scene(random, 0.0);
    Mpc mpc(scene.robot, scene.options);
    mpc.restart(scene.mode, scene.range());
    const MpcAnswer answer = mpc.solve(scene.reference, scene.t, scene.state);
    ASSERT_TRUE(answer.usable);
    const double h = 1.0 / scene.options.controller_frequency;
    const MotionState next = scene.reference.at(scene.t + h).state;
    EXPECT_NEAR(scene.state.v + h * answer.input.a, next.v, 2e-3);
    EXPECT_NEAR(scene.state.phi + h * answer.input.omega, next.phi, 2e-3);
    for (std::size_t k = 0; k < mpc.prediction().size(); k += 5)
      EXPECT_LT(distance(mpc.prediction()[k],
                         scene.reference.at(scene.t + (k == 0 ? 0.0 : h + (1.0 - h) * double(k - 1) / 24)).state.pose),
                2e-3);
  }
}

/// Without bounds the problem is linear least squares in all inputs, which dense algebra solves as well.
TEST(Mpc, WhereNoBoundIsActiveItIsTheLeastSquaresSolution)
{
  Random random(kSeed);
  int compared = 0;
  for (int trial = 0; trial < 60; ++trial)
  {
    const Scene scene(random, 0.003);
    Mpc mpc(scene.robot, scene.options);
    mpc.restart(scene.mode, scene.range());
    ASSERT_TRUE(mpc.solve(scene.reference, scene.t, scene.state).usable);
    const std::vector<ErrorInput> zero(mpc.solution().controls.size(), ErrorInput::Zero());
    // The cost is quadratic, so its gradient and Hessian follow exactly from values at unit inputs.
    const int n = 2 * static_cast<int>(zero.size());
    const auto at = [&](int i, int j) {
      std::vector<ErrorInput> inputs = zero;
      if (i >= 0) inputs[static_cast<std::size_t>(i / 2)][i % 2] += 1.0;
      if (j >= 0) inputs[static_cast<std::size_t>(j / 2)][j % 2] += 1.0;
      return cost(mpc, inputs);
    };
    const double none = at(-1, -1);
    Eigen::MatrixXd hessian(n, n);
    Eigen::VectorXd gradient(n), single(n);
    for (int i = 0; i < n; ++i) single[i] = at(i, -1);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) hessian(i, j) = at(i, j) - single[i] - single[j] + none;
    gradient = single.array() - none - 0.5 * hessian.diagonal().array();
    const Eigen::VectorXd best = -hessian.ldlt().solve(gradient);
    std::vector<ErrorInput> inputs = zero;
    for (int i = 0; i < n; ++i) inputs[static_cast<std::size_t>(i / 2)][i % 2] = best[i];
    if (!is_feasible(mpc, inputs)) continue;
    ++compared;
    EXPECT_NEAR(mpc.solution().controls[0][0], best[0], 0.02) << "seed " << kSeed << ", trial " << trial;
    EXPECT_NEAR(mpc.solution().controls[0][1], best[1], 0.02) << "seed " << kSeed << ", trial " << trial;
  }
  EXPECT_GT(compared, 5);
}

TEST(Mpc, KeepsItsBoundsAndNothingNearbyThatDoesCostsLess)
{
  Random random(kSeed);
  for (int trial = 0; trial < 60; ++trial)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const Scene scene(random, 0.15);
    Mpc mpc(scene.robot, scene.options);
    mpc.restart(scene.mode, scene.range());
    ASSERT_TRUE(mpc.solve(scene.reference, scene.t, scene.state).usable);
    const std::vector<ErrorInput> found = mpc.solution().controls;
    EXPECT_TRUE(is_feasible(mpc, found));
    const double least = cost(mpc, found);
    for (int change = 0; change < 200; ++change)
    {
      std::vector<ErrorInput> other = found;
      const double size = std::pow(10.0, random.between(-3.0, 0.0));
      for (ErrorInput& input : other) input += size * ErrorInput(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
      if (!is_feasible(mpc, other)) continue;
      EXPECT_GE(cost(mpc, other), least - 1e-3);
    }
  }
}

TEST(Mpc, AWarmStartDoesNotChangeTheAnswer)
{
  Random random(kSeed);
  for (int trial = 0; trial < 60; ++trial)
  {
    const Scene scene(random, 0.05);
    Mpc warm(scene.robot, scene.options), cold(scene.robot, scene.options);
    warm.restart(scene.mode, scene.range());
    for (const double earlier : {0.06, 0.04, 0.02})
    {
      MotionState before = scene.reference.at(scene.t - earlier).state;
      before.pose.x += 0.01;
      ASSERT_TRUE(warm.solve(scene.reference, scene.t - earlier, before).usable);
    }
    cold.restart(scene.mode, scene.range());
    const MpcAnswer a = warm.solve(scene.reference, scene.t, scene.state);
    const MpcAnswer b = cold.solve(scene.reference, scene.t, scene.state);
    EXPECT_NEAR(a.input.a, b.input.a, 0.02);
    EXPECT_NEAR(a.input.omega, b.input.omega, 0.02);
  }
}

TEST(Mpc, StatesBeyondTheBoundsStillHaveAnAnswer)
{
  Random random(kSeed);
  for (int trial = 0; trial < 60; ++trial)
  {
    Scene scene(random, 0.3);
    scene.state.v = random.between(-3.0, 3.0);
    scene.state.phi = random.between(-3.0, 3.0);
    Mpc mpc(scene.robot, scene.options);
    mpc.restart(scene.mode, scene.range());
    const MpcAnswer answer = mpc.solve(scene.reference, scene.t, scene.state);
    EXPECT_TRUE(answer.usable) << "seed " << kSeed << ", trial " << trial;
    EXPECT_LE(std::abs(answer.input.a), scene.robot.max_acceleration + 1e-6);
  }
}

/// The greatest share of each limit that a solution uses.
struct Shares
{
  double acceleration = 0.0, steering_rate = 0.0, wheel_rate = 0.0, speed = 0.0, wheel_speed = 0.0, phi = 0.0;
};

/// The shares of a solution. The limits of the wheels are linearised about the steering angle of the reference.
Shares shares_of(const Mpc& mpc, const Scene& scene, const Robot& robot, double max_phi)
{
  const double first = 1.0 / scene.options.controller_frequency, horizon = scene.options.horizon;
  const int count = scene.options.knots;
  const auto time = [&](int k) { return k == 0 ? 0.0 : first + (horizon - first) * (k - 1) / (count - 1); };
  Shares shares;
  for (int k = 0; k < count; ++k)
  {
    const auto at = static_cast<std::size_t>(k);
    const double h = time(k + 1) - time(k), slope = 1e-6;
    const MotionState from = scene.reference.at(scene.t + time(k)).state;
    const MotionState to = scene.reference.at(scene.t + time(k + 1)).state;
    const double middle = scene.reference.at(scene.t + 0.5 * (time(k) + time(k + 1))).state.phi;
    const double a = (to.v - from.v) / h + mpc.solution().controls[at][0];
    const double omega = (to.phi - from.phi) / h + mpc.solution().controls[at][1];
    const double v = std::abs(to.v + mpc.solution().states[at + 1][3]);
    const double phi = std::abs(to.phi + mpc.solution().states[at + 1][4]);
    const WheelAngles left = wheel_angles(robot, scene.mode, middle - slope);
    const WheelAngles right = wheel_angles(robot, scene.mode, middle + slope);
    for (std::size_t i = 0; i < left.size(); ++i)
      shares.wheel_rate = std::max(
          shares.wheel_rate, std::abs(wrap_angle(right[i] - left[i]) / (2.0 * slope) * omega) / robot.wheel_max_rate);
    shares.acceleration = std::max(shares.acceleration, std::abs(a) / robot.max_acceleration);
    shares.steering_rate = std::max(shares.steering_rate, std::abs(omega) / robot.max_steering_rate);
    shares.phi = std::max(shares.phi, phi / max_phi);
    // A robot that is too fast at first may brake.
    const double excess = std::abs(scene.state.v) - robot.max_acceleration * time(k + 1);
    shares.speed = std::max(shares.speed, v / std::max(robot.max_speed, excess));
    const double by_wheels = robot.wheel_max_speed / wheel_speed_ratio(robot, scene.mode, to.phi);
    shares.wheel_speed = std::max(shares.wheel_speed, v / std::max(by_wheels, excess));
  }
  return shares;
}

/// Each limit in turn is lower than that of the reference, so that the solution reaches it.
TEST(Mpc, KeepsTheLimitsOfTheRobotAndUsesThem)
{
  struct Limit
  {
    const char* name;
    double Robot::*limit;  ///< null: the range of phi
    double value;
    double Shares::*share;
  };
  const Limit limits[] = {{"max_acceleration", &Robot::max_acceleration, 1.0, &Shares::acceleration},
                          {"max_steering_rate", &Robot::max_steering_rate, 0.4, &Shares::steering_rate},
                          {"wheel_max_rate", &Robot::wheel_max_rate, 0.4, &Shares::wheel_rate},
                          {"max_speed", &Robot::max_speed, 0.3, &Shares::speed},
                          {"wheel_max_speed", &Robot::wheel_max_speed, 0.3, &Shares::wheel_speed},
                          {"phi", nullptr, 0.2, &Shares::phi}};
  for (const Limit& limit : limits)
  {
    SCOPED_TRACE(limit.name);
    Random random(kSeed);
    int usable = 0, used = 0;
    for (int trial = 0; trial < 60; ++trial)
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
      const Scene scene(random, 0.15);
      Robot robot = scene.robot;
      if (limit.limit) robot.*limit.limit = limit.value;
      const double max_phi = limit.limit ? scene.range().high : limit.value;
      Mpc mpc(robot, scene.options);
      mpc.restart(scene.mode, {-max_phi, max_phi});
      if (!mpc.solve(scene.reference, scene.t, scene.state).usable) continue;
      ++usable;
      const Shares shares = shares_of(mpc, scene, robot, max_phi);
      for (const Limit& any : limits) EXPECT_LE(shares.*any.share, 1.0 + 1e-6) << any.name;
      if (shares.*limit.share > 0.99) ++used;
    }
    EXPECT_GT(usable, 50);
    EXPECT_GT(used, 20);
  }
}

}  // namespace
}  // namespace fourwis
