// Robots whose wheels turn within 41 to 180 degrees: the search must not ask for what the referee refuses.

#include <gtest/gtest.h>

#include "fourwis_navigation/planner/planner.h"
#include "fourwis_navigation/vehicle/mode_limits.h"
#include "hall.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 101;
constexpr double kDegree = M_PI / 180.0;

Robot any_robot(Random& random)
{
  Robot robot;
  robot.length = random.between(0.3, 1.2);
  robot.width = robot.length * random.between(0.5, 1.2);
  robot.wheelbase = robot.length * random.between(0.3, 1.0);
  robot.track_width = robot.width * random.between(0.3, 1.0);
  robot.max_steering_angle = random.between(10.0, 80.0) * kDegree;
  robot.max_steering_rate = random.between(1.0, 4.0);
  robot.wheel_max_rate = random.between(1.0, 4.0);
  robot.max_speed = random.between(0.3, 2.0);
  robot.wheel_max_speed = robot.max_speed * random.between(1.0, 3.0);
  robot.max_acceleration = random.between(0.5, 5.0);
  robot.safety_margin = random.between(0.0, 0.05);
  robot.wheel_max_angle = random.between(41.0, 180.0) * kDegree;
  return robot;
}

TEST(WheelTravel, OfRandomRobotsNeverMakesAPlanThatIsRefused)
{
  Random random(kSeed);
  PlannerOptions options;
  options.planner_patience = 60.0;
  options.search.max_expansions = 3000;
  int solved = 0;
  for (int k = 0; k < 40; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", robot " + std::to_string(k));
    const Robot robot = any_robot(random);
    const World world(clutter(random, 7.0, 0.05, 5, random.pose(5.0)), robot, options);
    const OccupancyGrid at_origin = [&] {
      OccupancyGrid grid = world.grid;
      grid.origin = {};
      return grid;
    }();
    const Site site(at_origin, robot);
    const ModeSet modes = all_mode_sets()[static_cast<std::size_t>(k) % 7];
    PlanRequest request = {free_pose(random, site.checker), free_pose(random, site.checker), modes};
    request.start = compose(world.grid.origin, request.start);
    request.goal = compose(world.grid.origin, request.goal);
    const PlanResult result = Planner(options).plan(world, request);
    ASSERT_STRNE(to_string(result.status), to_string(PlanStatus::verification_failed)) << result.message;
    if (result.status != PlanStatus::succeeded) continue;
    ++solved;
    const DriveLimits limits(robot);
    for (const TrajectoryPoint& point : result.trajectory)
    {
      ASSERT_TRUE(limits.possible().contains(point.mode)) << to_string(point.mode);
      ASSERT_LE(std::abs(point.phi), limits[point.mode].phi + 1e-6) << to_string(point.mode);
    }
    const Verdict verdict = Referee(world.grid, options.obstacles, robot, options.referee)
                                .judge(request.start, request.goal, result.trajectory);
    ASSERT_TRUE(verdict.accepted()) << verdict.violations.front().what;
  }
  EXPECT_GT(solved, 20);
}

}  // namespace
}  // namespace fourwis
