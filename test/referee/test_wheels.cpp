// The rules for mode switches and wheels: a trajectory that just keeps one is accepted, one that just breaks it is not.

#include "referee_tour.h"

namespace fourwis
{
namespace
{

TEST(VerifyWheels, WantsTheSwitchTimeEvenWhenNoWheelTurns)
{
  const auto take = [](double duration) {
    return judge(Script({}, Mode::ackermann).drive(0.5, 0.5).switch_to(Mode::parallel, 0.0, duration));
  };
  expect_accepted(take(0.4));
  expect_refused(take(0.3999), "duration of a mode switch");
}

TEST(VerifyWheels, WantsTimeForTheWheelsToTurnTheirShorterWay)
{
  const auto take = [](Mode to, double phi, double duration, const Robot& robot = {}) {
    return judge(Script({}, Mode::ackermann).switch_to(to, phi, duration).drive(0.2, 0.5), robot);
  };
  expect_accepted(take(Mode::lateral, 0.0, 0.5));
  expect_refused(take(Mode::lateral, 0.0, 0.4999), "time to turn at rest of the front left wheel");
  // A turn by 100 degrees is one by 80 the other way. With a travel of 95 degrees only the one by 80 is possible.
  expect_accepted(take(Mode::parallel, 100.0 * kDegree, 80.1 / 180.0));
  expect_refused(take(Mode::parallel, 100.0 * kDegree, 79.9 / 180.0), "time to turn at rest");
  expect_accepted(take(Mode::parallel, 1.0 * kDegree, 0.4));
}

TEST(VerifyWheels, CountsTheWayAroundAStop)
{
  const auto turn = [](double max_angle) {
    Robot robot;
    robot.wheel_max_angle = max_angle;
    robot.wheel_max_rate = M_PI / 2.0;
    Script script({}, Mode::parallel, 80.0 * kDegree);
    script.drive(0.2, 0.5).go(1.0, 0.0, -80.0 * kDegree).drive(0.2, 0.5);
    return judge(script, robot);
  };
  expect_accepted(turn(160.0 * kDegree));                        // 20 degrees, from 80 to 100
  expect_refused(turn(90.0 * kDegree), "time to turn at rest");  // 160 degrees
}

TEST(VerifyWheels, WantsThePoseToStayDuringASwitch)
{
  const auto moved = [](double x, double theta) {
    return judge_changed([&](Trajectory& p) {
      for (std::size_t i = 5; i < p.size(); ++i) p[i].x += x, p[i].theta += theta;
    });
  };
  expect_accepted(moved(0.9e-6, 0.9e-6));
  expect_refused(moved(1.1e-6, 0.0), "motion during a mode switch");
  expect_refused(moved(0.0, 1.1e-6), "turn during a mode switch");
}

TEST(VerifyWheels, WantsRestAtBothSidesOfASwitch)
{
  expect_accepted(judge_changed([](Trajectory& p) { p[4].v = 0.9e-6, p[5].v = -0.9e-6; }));
  expect_refused(judge_changed([](Trajectory& p) { p[4].v = 1.1e-6; }), "speed at a mode switch");
  expect_refused(judge_changed([](Trajectory& p) { p[5].v = -1.1e-6; }), "speed at a mode switch");
}

/// Steering angle of a wheel modulo 2 pi and its speed for unit speed of C, the centre of the wheels: the velocity of a
/// point of a rigid body.
void wheel(Mode mode, double phi, int index, double& angle, double& speed)
{
  const Robot robot;
  const WheelPosition at = wheel_positions(robot)[static_cast<std::size_t>(index)];
  double vx = std::cos(phi), vy = std::sin(phi), turn = 0.0;
  if (mode == Mode::ackermann) vx = 1.0, vy = 0.0, turn = 2.0 * std::tan(phi) / robot.wheelbase;
  if (mode == Mode::lateral) vx = 0.0, vy = 1.0, turn = 2.0 * std::tan(phi) / robot.track_width;
  angle = std::atan2(vy + turn * at.x, vx - turn * at.y);
  speed = std::hypot(vy + turn * at.x, vx - turn * at.y);
}

TEST(VerifyWheels, HoldsTheWheelsSteeringRateAgainstItsLimitInMotion)
{
  for (const Mode mode : kPlannedModes)
    for (const auto& [from, to] : {std::pair(-0.5, 0.5), std::pair(0.2, 0.5), std::pair(0.0, -0.3)})
    {
      double gain = 0.0;  // by differences, over all wheels and angles
      for (int k = 0; k < 20000; ++k)
        for (int i = 0; i < kWheels; ++i)
        {
          double one, other, speed;
          const double h = (to - from) / 20000;
          wheel(mode, from + k * h, i, one, speed);
          wheel(mode, from + (k + 1) * h, i, other, speed);
          gain = std::max(gain, std::abs(wrap_angle(other - one) / h));
        }
      SCOPED_TRACE(to_string(mode) + std::string(" from ") + std::to_string(from) + ", gain " + std::to_string(gain));
      Robot robot;
      robot.max_steering_rate = 20.0;
      const auto steer = [&](double wheel_rate) {
        const double duration = gain * std::abs(to - from) / wheel_rate;
        return judge(Script({}, mode, from).go(0.2, 0.5, from).go(duration, 0.5, to).go(0.2, 0.0, to), robot);
      };
      expect_accepted(steer(robot.wheel_max_rate * 0.999));
      expect_refused(steer(robot.wheel_max_rate * 1.001), "steering rate of the");
    }
}

TEST(VerifyWheels, HoldsTheWheelsSpeedAgainstItsLimit)
{
  for (const Mode mode : kPlannedModes)
    for (const double phi : {-0.5, 0.1, 0.5})
    {
      double factor = 0.0;
      for (int i = 0; i < kWheels; ++i)
      {
        double angle, speed;
        wheel(mode, phi, i, angle, speed);
        factor = std::max(factor, speed);
      }
      SCOPED_TRACE(to_string(mode) + std::string(", factor ") + std::to_string(factor));
      const auto drive = [&](double max_speed) {
        Robot robot;
        robot.wheel_max_speed = max_speed;
        return judge(Script({}, mode, phi).drive(0.8, 0.5), robot);
      };
      expect_accepted(drive(0.8 * factor * 1.00001));
      expect_refused(drive(0.8 * factor * 0.9999), "rolling speed of the");
    }
}

TEST(VerifyWheels, SeesAWheelThatIsTooFastOnlyBetweenTwoPoints)
{
  // The speed falls while the steering angle grows: the wheel is fastest at neither end.
  Robot robot;
  const auto drive = [&] {
    return judge(Script({}, Mode::lateral).go(0.2, 0.9, 0.0).go(1.0, 0.5, 0.52).go(0.2, 0.0, 0.52), robot);
  };
  double fastest = 0.0;
  for (int k = 0; k <= 1000; ++k)
  {
    double angle, speed;
    wheel(Mode::lateral, 0.52 * k / 1000, 0, angle, speed);
    fastest = std::max(fastest, (0.9 - 0.4 * k / 1000) * speed);
  }
  ASSERT_GT(fastest, 0.95);
  robot.wheel_max_speed = fastest * 1.0001;
  expect_accepted(drive());
  robot.wheel_max_speed = fastest * 0.999;
  expect_refused(drive(), "rolling speed of the");
}

TEST(VerifyWheels, LetsAWheelFlipAtRestButNotInMotion)
{
  Robot robot;
  robot.wheel_max_angle = 100.0 * kDegree;
  const double phi = 25.0 * kDegree;  // the wheels turn between 40 and 106 or 74 and 140 degrees, or 180 less
  expect_accepted(judge(Script({}, Mode::lateral, -phi).drive(0.4, 0.5).go(1.0, 0.0, phi).drive(0.4, 0.5), robot));
  Script turning = Script({}, Mode::lateral, -phi).go(0.2, 0.4, -phi).go(1.0, 0.4, phi).go(0.2, 0.0, phi);
  expect_refused(judge(turning, robot), "without rest");
  expect_refused(judge(turning.go(1.0, 0.0, 0.0).drive(0.4, 0.5), robot), "without rest");
}

TEST(VerifyWheels, KeepsABranchWhileTheSpeedPassesThroughZero)
{
  Robot robot;
  robot.wheel_max_angle = 100.0 * kDegree;
  const double phi = 25.0 * kDegree;
  expect_refused(judge(Script({}, Mode::lateral, -phi).go(0.2, 0.4, -phi).go(1.0, -0.4, phi).go(0.2, 0.0, phi), robot),
                 "without rest");
  expect_refused(
      judge(Script({}, Mode::lateral, -phi).go(0.2, 0.4, -phi).go(0.5, 0.0, 0.0).go(0.5, 0.4, phi).go(0.2, 0.0, phi),
            robot),
      "without rest");
}

}  // namespace
}  // namespace fourwis
