// What a trajectory promises about speeds, times, poses and wheels: just kept it is accepted, just broken refused.

#include <gtest/gtest.h>

#include <functional>

#include "verify_script.h"

namespace fourwis
{
namespace
{

constexpr double kDegree = M_PI / 180.0;

const OccupancyGrid& hall()
{
  static const OccupancyGrid grid = empty_grid(400, 400, 0.05, {-10.0, -10.0, 0.0});
  return grid;
}

Verdict judge(const Trajectory& points, const Pose& start, const Pose& goal, const Robot& robot = {})
{
  return Referee(hall(), ObstacleRule(), robot).judge(start, goal, points);
}

Verdict judge(const Script& script, const Robot& robot = {})
{
  return judge(script.points(), script.start(), script.end(), robot);
}

/// All modes, steering in motion and at rest, both directions, two switches.
Script grand_tour()
{
  Script script({-1.0, 0.5, 0.3}, Mode::ackermann);
  script.go(0.25, 1.0, 0.0).go(0.5, 1.0, 0.4).go(0.5, 0.5, -0.1).go(0.25, 0.0, -0.1);
  script.switch_to(Mode::lateral, 0.2, 0.6);
  script.go(0.25, -0.8, 0.2).go(0.5, -0.8, -0.2).go(0.25, 0.0, -0.2);
  script.switch_to(Mode::parallel, 1.0, 0.6);
  script.go(0.25, 1.0, 1.0).go(0.5, 1.0, 1.8).go(0.25, 0.0, 1.8).go(1.0, 0.0, 0.3).drive(-0.5, 1.0);
  return script;
}

void expect_accepted(const Verdict& verdict)
{
  EXPECT_TRUE(verdict.accepted()) << sentences(verdict);
}

void expect_refused(const Verdict& verdict, const std::string& what)
{
  EXPECT_FALSE(verdict.accepted()) << "expected: " << what;
  EXPECT_TRUE(complains_of(verdict, what)) << "expected: " << what << "\nfound:\n" << sentences(verdict);
}

/// The tour with something done to its points, start and goal where they were.
Verdict judge_changed(const std::function<void(Trajectory&)>& change)
{
  const Script tour = grand_tour();
  Trajectory points = tour.points();
  change(points);
  return judge(points, tour.start(), tour.end());
}

TEST(Verify, AcceptsATourThroughAllModes)
{
  const Verdict verdict = judge(grand_tour());
  expect_accepted(verdict);
  EXPECT_LT(verdict.max_rollout_position, 1e-6);
  EXPECT_LT(verdict.max_rollout_angle, 1e-6);
  EXPECT_EQ(verdict.terminal_position_error, 0.0);
  EXPECT_GT(verdict.min_clearance, 5.0);
}

TEST(Verify, AcceptsTheTourWhateverTheFrameOfTheGrid)
{
  const Script tour = grand_tour();
  const OccupancyGrid turned = empty_grid(800, 800, 0.05, {5.0, -25.0, 0.8});
  expect_accepted(Referee(turned, {}, {}).judge(tour.start(), tour.end(), tour.points()));
}

TEST(Verify, AcceptsStandingStillWhenStartIsGoal)
{
  const Script one({0.0, 0.0, 1.0}, Mode::lateral);
  expect_accepted(judge(one));
  expect_accepted(judge(Script(one).go(1.0, 0.0, 0.0)));
  expect_refused(judge(one.points(), one.start(), {1.0, 0.0, 1.0}), "goal position");
}

TEST(Verify, RefusesNoPointsAtAll)
{
  expect_refused(judge({}, {}, {}), "no points");
}

TEST(Verify, RefusesTimesThatDoNotIncrease)
{
  expect_refused(judge_changed([](Trajectory& p) { p[2].t = p[1].t; }), "time not after");
  expect_refused(judge_changed([](Trajectory& p) { p[2].t = p[0].t; }), "time not after");
}

TEST(Verify, RefusesAStartTimeOtherThanZero)
{
  expect_refused(judge_changed([](Trajectory& p) { for (auto& point : p) point.t += 0.1; }), "first point");
}

TEST(Verify, RefusesModesThatAreNotPlanned)
{
  for (const Mode mode : {Mode::none, Mode::spin, static_cast<Mode>(77)})
    expect_refused(judge_changed([&](Trajectory& p) { p[1].mode = mode; }), "mode number");
}

TEST(Verify, HoldsTheStartAgainstItsTolerance)
{
  const Script tour = grand_tour();
  const auto shifted = [&](double x, double theta)
  {
    Pose start = tour.start();
    start.x += x, start.theta += theta;
    return judge(tour.points(), start, tour.end());
  };
  expect_accepted(shifted(0.00099, 0.00099));
  expect_accepted(shifted(0.0, 2.0 * M_PI));
  expect_refused(shifted(0.00101, 0.0), "start position");
  expect_refused(shifted(0.0, -0.00101), "start heading");
}

TEST(Verify, HoldsTheGoalAgainstItsTolerance)
{
  const Script tour = grand_tour();
  const auto shifted = [&](double y, double theta)
  {
    Pose goal = tour.end();
    goal.y += y, goal.theta += theta;
    return judge(tour.points(), tour.start(), goal);
  };
  expect_accepted(shifted(-0.00099, -0.00099));
  expect_accepted(shifted(0.0, -6.0 * M_PI));
  expect_refused(shifted(-0.00101, 0.0), "goal position");
  expect_refused(shifted(0.0, 0.00101), "goal heading");
  EXPECT_NEAR(shifted(0.3, 0.0).terminal_position_error, 0.3, 1e-12);
  EXPECT_NEAR(shifted(0.0, 0.2 + 2.0 * M_PI).terminal_yaw_error, 0.2, 1e-9);
}

TEST(Verify, WantsRestAtBothEnds)
{
  expect_accepted(judge_changed([](Trajectory& p) { p.front().v = 5e-7; }));
  expect_refused(judge_changed([](Trajectory& p) { p.front().v = 2e-6; }), "speed at the start");
  expect_refused(judge_changed([](Trajectory& p) { p.back().v = -2e-6; }), "speed at the goal");
}

TEST(Verify, HoldsSpeedAgainstItsLimit)
{
  for (const Mode mode : kPlannedModes)
    for (const double sign : {-1.0, 1.0})
    {
      expect_accepted(judge(Script({}, mode).drive(sign * 1.0, 1.0)));
      expect_refused(judge(Script({}, mode).drive(sign * 1.00001, 1.0)), "speed " + std::string(sign < 0 ? "-1" : "1"));
    }
}

TEST(Verify, HoldsAccelerationAgainstItsLimit)
{
  expect_accepted(judge(Script({}, Mode::lateral).go(0.2, 1.0, 0.0).go(0.2, 0.0, 0.0)));
  expect_refused(judge(Script({}, Mode::lateral).go(0.1999, 1.0, 0.0).go(0.2, 0.0, 0.0)), "acceleration 5.00");
  expect_refused(judge(Script({}, Mode::lateral).go(0.2, 1.0, 0.0).go(0.1999, 0.0, 0.0)), "acceleration -5.00");
}

TEST(Verify, HoldsTheSteeringAngleAgainstItsLimit)
{
  for (const Mode mode : kPlannedModes)
    for (const double sign : {-1.0, 1.0})
    {
      const double limit = sign * (mode == Mode::parallel ? 160.0 : 30.0) * kDegree;
      expect_accepted(judge(Script({}, mode, limit).drive(0.5, 0.5)));
      expect_refused(judge(Script({}, mode, limit + sign * 1e-5).drive(0.5, 0.5)), "steering angle");
      expect_refused(judge(Script({}, mode, limit + sign * 1e-5)), "steering angle");
    }
}

TEST(Verify, HoldsTheSteeringRateAgainstItsLimitAtRestToo)
{
  Robot robot;
  robot.wheel_max_rate = 20.0;
  for (const double v : {0.0, 0.5})
  {
    const auto steer = [&](double duration)
    { return judge(Script({}, Mode::ackermann).go(0.2, v, 0.0).go(duration, v, 0.3).go(0.2, 0.0, 0.3), robot); };
    expect_accepted(steer(0.3 / M_PI * 1.00001));
    expect_refused(steer(0.3 / M_PI * 0.9999), "steering rate");
  }
}

TEST(Verify, WantsTheFieldsAAndOmegaToAgreeWithTheDifferences)
{
  expect_accepted(judge_changed([](Trajectory& p) { p[1].a += 0.9e-3 * 5.0, p[1].omega -= 0.9e-3 * M_PI; }));
  expect_refused(judge_changed([](Trajectory& p) { p[1].a += 1.1e-3 * 5.0; }), "actual acceleration");
  expect_refused(judge_changed([](Trajectory& p) { p[1].omega -= 1.1e-3 * M_PI; }), "actual steering rate");
  expect_accepted(judge_changed([](Trajectory& p) { p.back().a = 3.0, p.back().omega = -2.0; }));
}

TEST(Verify, HoldsTheRollOutAgainstItsTolerance)
{
  const Script script = Script({}, Mode::lateral, 0.4).drive(0.8, 1.0);
  const auto end_moved = [&](double x, double theta)
  {
    Trajectory points = script.points();
    points.back().x += x, points.back().theta += theta;
    return judge(points, script.start(), points.back().pose());
  };
  expect_accepted(end_moved(0.00499, 0.00999));
  expect_refused(end_moved(-0.00501, 0.0), "rolled-out");
  expect_refused(end_moved(0.0, 0.01001), "rolled-out");
  expect_refused(end_moved(0.0, 2.0 * M_PI), "rolled-out");
  EXPECT_NEAR(end_moved(0.3, 0.0).max_rollout_position, 0.3, 1e-6);
  EXPECT_NEAR(end_moved(0.0, 0.2).max_rollout_angle, 0.2, 1e-6);
}

TEST(Verify, RefusesThePapersEulerStepAtFullLock)
{
  const double phi = M_PI / 6.0, v = 1.0, step = 0.2;
  Script script({}, Mode::ackermann, phi);
  Trajectory points = script.go(0.25, v, phi).points();
  for (int k = 0; k < 5; ++k)
  {
    TrajectoryPoint next = points.back();
    next.t += step / v;
    next.x += step * std::cos(next.theta), next.y += step * std::sin(next.theta);
    next.theta += 2.0 * std::tan(phi) / Robot().wheelbase * step;
    points.back().a = 0.0;
    points.push_back(next);
  }
  const Verdict verdict = judge(points, script.start(), points.back().pose());
  expect_refused(verdict, "distance from the rolled-out");
  EXPECT_NEAR(verdict.max_rollout_position, 0.034, 0.002);  // DESIGN.md section 3
}

TEST(Verify, WantsTheSwitchTimeEvenWhenNoWheelTurns)
{
  const auto take = [](double duration)
  { return judge(Script({}, Mode::ackermann).drive(0.5, 0.5).switch_to(Mode::parallel, 0.0, duration)); };
  expect_accepted(take(0.4));
  expect_refused(take(0.3999), "duration of a mode switch");
}

TEST(Verify, WantsTimeForTheWheelsToTurnTheirShorterWay)
{
  const auto take = [](Mode to, double phi, double duration, const Robot& robot = {})
  { return judge(Script({}, Mode::ackermann).switch_to(to, phi, duration).drive(0.2, 0.5), robot); };
  expect_accepted(take(Mode::lateral, 0.0, 0.5));
  expect_refused(take(Mode::lateral, 0.0, 0.4999), "time to turn at rest of the front left wheel");
  // 100 degrees are 80 the other way round; with stops at 95 degrees there are only those 80.
  expect_accepted(take(Mode::parallel, 100.0 * kDegree, 80.1 / 180.0));
  expect_refused(take(Mode::parallel, 100.0 * kDegree, 79.9 / 180.0), "time to turn at rest");
  expect_accepted(take(Mode::parallel, 1.0 * kDegree, 0.4));
}

TEST(Verify, CountsTheWayAroundAStop)
{
  const auto turn = [](double max_angle)
  {
    Robot robot;
    robot.wheel_max_angle = max_angle;
    robot.wheel_max_rate = M_PI / 2.0;
    Script script({}, Mode::parallel, 80.0 * kDegree);
    script.drive(0.2, 0.5).go(1.0, 0.0, -80.0 * kDegree).drive(0.2, 0.5);
    return judge(script, robot);
  };
  expect_accepted(turn(160.0 * kDegree));  // 20 degrees, from 80 to 100
  expect_refused(turn(90.0 * kDegree), "time to turn at rest");  // 160 degrees
}

TEST(Verify, WantsThePoseToStayDuringASwitch)
{
  const auto moved = [](double x, double theta)
  {
    return judge_changed([&](Trajectory& p)
    {
      for (std::size_t i = 5; i < p.size(); ++i) p[i].x += x, p[i].theta += theta;
    });
  };
  expect_accepted(moved(0.9e-6, 0.9e-6));
  expect_refused(moved(1.1e-6, 0.0), "motion during a mode switch");
  expect_refused(moved(0.0, 1.1e-6), "turn during a mode switch");
}

TEST(Verify, WantsRestAtBothSidesOfASwitch)
{
  expect_accepted(judge_changed([](Trajectory& p) { p[4].v = 0.9e-6, p[5].v = -0.9e-6; }));
  expect_refused(judge_changed([](Trajectory& p) { p[4].v = 1.1e-6; }), "speed at a mode switch");
  expect_refused(judge_changed([](Trajectory& p) { p[5].v = -1.1e-6; }), "speed at a mode switch");
}

/// Steering angle of a wheel modulo 2 pi and its speed for unit speed of C: the velocity of a point of a rigid body.
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

TEST(Verify, HoldsTheWheelsSteeringRateAgainstItsLimitInMotion)
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
      const auto steer = [&](double wheel_rate)
      {
        const double duration = gain * std::abs(to - from) / wheel_rate;
        return judge(Script({}, mode, from).go(0.2, 0.5, from).go(duration, 0.5, to).go(0.2, 0.0, to), robot);
      };
      expect_accepted(steer(robot.wheel_max_rate * 0.999));
      expect_refused(steer(robot.wheel_max_rate * 1.001), "steering rate of the");
    }
}

TEST(Verify, HoldsTheWheelsSpeedAgainstItsLimit)
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
      const auto drive = [&](double max_speed)
      {
        Robot robot;
        robot.wheel_max_speed = max_speed;
        return judge(Script({}, mode, phi).drive(0.8, 0.5), robot);
      };
      expect_accepted(drive(0.8 * factor * 1.00001));
      expect_refused(drive(0.8 * factor * 0.9999), "rolling speed of the");
    }
}

TEST(Verify, SeesAWheelThatIsTooFastOnlyBetweenTwoPoints)
{
  // Slowing down while the lock grows: fastest at neither end.
  Robot robot;
  const auto drive = [&]
  { return judge(Script({}, Mode::lateral).go(0.2, 0.9, 0.0).go(1.0, 0.5, 0.52).go(0.2, 0.0, 0.52), robot); };
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

TEST(Verify, LetsAWheelFlipAtRestButNotInMotion)
{
  Robot robot;
  robot.wheel_max_angle = 100.0 * kDegree;
  const double phi = 25.0 * kDegree;  // the wheels turn between 40 and 106 or 74 and 140 degrees, or 180 less
  expect_accepted(judge(Script({}, Mode::lateral, -phi).drive(0.4, 0.5).go(1.0, 0.0, phi).drive(0.4, 0.5), robot));
  Script turning = Script({}, Mode::lateral, -phi).go(0.2, 0.4, -phi).go(1.0, 0.4, phi).go(0.2, 0.0, phi);
  expect_refused(judge(turning, robot), "without rest");
  expect_refused(judge(turning.go(1.0, 0.0, 0.0).drive(0.4, 0.5), robot), "without rest");
}

TEST(Verify, KeepsABranchWhileTheSpeedPassesThroughZero)
{
  Robot robot;
  robot.wheel_max_angle = 100.0 * kDegree;
  const double phi = 25.0 * kDegree;
  expect_refused(judge(Script({}, Mode::lateral, -phi).go(0.2, 0.4, -phi).go(1.0, -0.4, phi).go(0.2, 0.0, phi), robot),
                 "without rest");
  expect_refused(judge(Script({}, Mode::lateral, -phi).go(0.2, 0.4, -phi).go(0.5, 0.0, 0.0).go(0.5, 0.4, phi)
                           .go(0.2, 0.0, phi), robot), "without rest");
}

TEST(Verify, SaysAHandfulAboutATrajectoryWrongEverywhere)
{
  const Verdict verdict = judge_changed([](Trajectory& p)
  {
    for (auto& point : p) point.v = 3.0, point.phi = 5.0, point.a = 100.0;
  });
  EXPECT_GE(verdict.violations.size(), 5u);
  EXPECT_LE(verdict.violations.size(), 40u);
  for (std::size_t i = 1; i < verdict.violations.size(); ++i)
    EXPECT_LE(verdict.violations[i - 1].point, verdict.violations[i].point);
}

TEST(Verify, SaysWhereAndWhen)
{
  const Verdict verdict = judge_changed([](Trajectory& p) { p[2].a += 1.0; });
  ASSERT_EQ(verdict.violations.size(), 1u);
  EXPECT_EQ(verdict.violations[0].point, 2);
  EXPECT_NEAR(verdict.violations[0].t, 0.75, 1e-12);
}

}  // namespace
}  // namespace fourwis
