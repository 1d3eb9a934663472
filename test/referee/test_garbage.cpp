// The referee answers on any input.

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "../support/fuzz_rounds.h"
#include "../support/grids.h"
#include "referee_script.h"

namespace fourwis
{
namespace
{

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Script drive()
{
  Script script({0.0, 0.0, 0.2}, Mode::ackermann);
  script.drive(1.0, 1.0).switch_to(Mode::lateral, 0.1, 0.6).drive(-0.5, 1.0);
  return script;
}

const Referee& referee()
{
  static const Referee instance(free_grid(200, 200, 0.05, {-5.0, -5.0, 0.0}), {}, {});
  return instance;
}

double* number(TrajectoryPoint& p, int k)
{
  double* const numbers[] = {&p.t, &p.x, &p.y, &p.theta, &p.v, &p.phi, &p.a, &p.omega};
  return numbers[k];
}

TEST(VerifyGarbage, AnyNumberThatIsNotFiniteIsRefused)
{
  const Script script = drive();
  for (const double value : {kNan, static_cast<double>(INFINITY), -static_cast<double>(INFINITY), 1e300, -1e300})
    for (std::size_t i = 0; i < script.points().size(); ++i)
      for (int k = 0; k < 8; ++k)
      {
        Trajectory points = script.points();
        *number(points[i], k) = value;
        const Verdict verdict = referee().judge(script.start(), script.end(), points);
        ASSERT_TRUE(complains_of(verdict, "not finite")) << "point " << i << ", number " << k << ", value " << value;
      }
}

TEST(VerifyGarbage, StartAndGoalThatAreNotFiniteAreRefused)
{
  const Script script = drive();
  ASSERT_TRUE(referee().judge(script.start(), script.end(), script.points()).accepted());
  for (const Pose& pose : {Pose{kNan, 0, 0}, Pose{0, INFINITY, 0}, Pose{0, 0, kNan}, Pose{0, 0, INFINITY}})
  {
    EXPECT_FALSE(referee().judge(pose, script.end(), script.points()).accepted());
    EXPECT_FALSE(referee().judge(script.start(), pose, script.points()).accepted());
  }
}

TEST(VerifyGarbage, RandomGarbageInAGoodTrajectoryIsAnswered)
{
  const double values[] = {0.0, -0.0, kNan, INFINITY, 1e-320, 1e-9, 1.0, M_PI_2, 1e5, 9e8, -9e8, 1e9, 1e18, 1e300};
  Random random(11);
  const Script script = drive();
  for (int k = 0; k < fuzz_rounds(5000); ++k)
  {
    Trajectory points = script.points();
    for (int changes = random.whole(1, 12); changes > 0; --changes)
    {
      const double value = values[random.whole(0, 13)] * (random.chance(0.5) ? 1.0 : -1.0);
      const int point = random.whole(0, static_cast<int>(points.size()) - 1);
      *number(points[static_cast<std::size_t>(point)], random.whole(0, 7)) = value;
    }
    const Verdict verdict = referee().judge(script.start(), script.end(), points);
    ASSERT_LE(verdict.violations.size(), 50u);
    ASSERT_FALSE(std::isnan(verdict.min_clearance));
    for (const Violation& violation : verdict.violations)
    {
      ASSERT_FALSE(violation.what.empty());
      ASSERT_LT(violation.point, static_cast<int>(points.size()));
    }
  }
}

TEST(VerifyGarbage, ManyPointsOfNonsenseAreAnswered)
{
  Random random(12);
  Trajectory points(20000);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int k = 1; k < 8; ++k) *number(points[i], k) = random.between(-1e6, 1e6);
    points[i].t = static_cast<double>(i) * 1000.0;
    points[i].mode = random.mode();
  }
  EXPECT_FALSE(referee().judge({}, {}, points).accepted());
}

TEST(VerifyGarbage, AnEndlessCircleIsNotFollowedForEver)
{
  TrajectoryPoint point;
  point.mode = Mode::ackermann;
  point.phi = 0.5;
  point.v = 1.0;
  Trajectory points{point, point};
  points[1].t = 9e8;
  const Verdict verdict = referee().judge({}, {}, points);
  EXPECT_TRUE(complains_of(verdict, "too long")) << sentences(verdict);
}

TEST(VerifyGarbage, AnUnusableGridIsRejectedByName)
{
  const auto message = [](const OccupancyGrid& grid) -> std::string {
    try
    {
      Referee(grid, {}, {});
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
    return "accepted";
  };
  OccupancyGrid grid = free_grid(10, 10, 0.1);
  EXPECT_EQ(message(grid), "accepted");
  grid.data.pop_back();
  EXPECT_NE(message(grid).find("data size 99"), std::string::npos);
  EXPECT_NE(message(free_grid(0, 10, 0.1)).find("width 0"), std::string::npos);
  EXPECT_NE(message(free_grid(10, 0, 0.1)).find("height 0"), std::string::npos);
  for (const double resolution : {0.0, -0.1, kNan, static_cast<double>(INFINITY)})
    EXPECT_NE(message(free_grid(10, 10, resolution)).find("resolution"), std::string::npos);
  EXPECT_NE(message(free_grid(10, 10, 0.1, {0.0, 0.0, kNan})).find("origin"), std::string::npos);
}

TEST(VerifyGarbage, AnUnusableRobotOrOptionIsRejectedByName)
{
  const auto message = [](const Robot& robot, const RefereeOptions& options) -> std::string {
    try
    {
      Referee(free_grid(10, 10, 0.1), {}, robot, options);
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message({}, {}), "accepted");
  Robot robot;
  robot.wheelbase = 0.0;
  EXPECT_NE(message(robot, {}).find("'wheelbase' is 0, expected"), std::string::npos);
  robot = {};
  robot.max_steering_angle = 1.6;
  EXPECT_NE(message(robot, {}).find("'max_steering_angle' is 1.6, expected"), std::string::npos);
  RefereeOptions options;
  options.collision_step = kNan;
  EXPECT_NE(message({}, options).find("collision_step"), std::string::npos);
  options = {};
  options.limit_tolerance = -1e-6;
  EXPECT_NE(message({}, options).find("limit_tolerance"), std::string::npos);
  ObstacleRule rule;
  rule.occupied_threshold = 0;
  EXPECT_THROW(Referee(free_grid(10, 10, 0.1), rule, {}), std::invalid_argument);
}

}  // namespace
}  // namespace fourwis
