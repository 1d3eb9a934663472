// The rules for speeds, times and poses: a trajectory that just keeps one is accepted, one that just breaks it is not.

#include "referee_tour.h"

namespace fourwis
{
namespace
{

TEST(Verify, AcceptsATourThroughAllModes)
{
  const Verdict verdict = judge(grand_tour());
  expect_accepted(verdict);
  EXPECT_LT(verdict.max_rollout_position, 1e-6);
  EXPECT_LT(verdict.max_rollout_angle, 1e-6);
  EXPECT_EQ(verdict.terminal_position_error, 0.0);
  EXPECT_GT(verdict.min_clearance, 5.0);
}

TEST(Verify, AcceptsTheTourInAnyFrameOfTheGrid)
{
  const Script tour = grand_tour();
  const OccupancyGrid turned = free_grid(800, 800, 0.05, {5.0, -25.0, 0.8});
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
  expect_refused(judge_changed([](Trajectory& p) {
                   for (auto& point : p) point.t += 0.1;
                 }),
                 "first point");
}

TEST(Verify, RefusesModesThatAreNotPlanned)
{
  for (const Mode mode : {Mode::none, Mode::spin, static_cast<Mode>(77)})
    expect_refused(judge_changed([&](Trajectory& p) { p[1].mode = mode; }), "mode number");
}

TEST(Verify, HoldsTheStartAgainstItsTolerance)
{
  const Script tour = grand_tour();
  const auto shifted = [&](double x, double theta) {
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
  const auto shifted = [&](double y, double theta) {
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
    const auto steer = [&](double duration) {
      return judge(Script({}, Mode::ackermann).go(0.2, v, 0.0).go(duration, v, 0.3).go(0.2, 0.0, 0.3), robot);
    };
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
  const auto end_moved = [&](double x, double theta) {
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
  EXPECT_NEAR(verdict.max_rollout_position, 0.034, 0.002);  // as doc/design.md says
}

TEST(Verify, SaysAHandfulAboutATrajectoryWrongEverywhere)
{
  const Verdict verdict = judge_changed([](Trajectory& p) {
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
