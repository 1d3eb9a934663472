// Robots whose base_link is not the centre of the wheels, and whose body is no rectangle around it.

#include <gtest/gtest.h>

#include "../support/exact_polygon.h"
#include "../support/sentences.h"
#include "fourwis_navigation/planner/planner.h"
#include "fourwis_navigation/vehicle/base_link.h"
#include "hall.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 37;

PlannerOptions patient()
{
  PlannerOptions options;
  options.planner_patience = 60.0;
  return options;
}

PlanResult plan(const OccupancyGrid& grid, const Robot& robot, const Pose& start, const Pose& goal)
{
  const PlannerOptions options = patient();
  return Planner(options).plan(World(grid, robot, options), {start, goal, {}});
}

/// The body along the whole motion, base_link where the trajectory has it.
void expect_driven(const OccupancyGrid& grid, const Robot& robot, const Pose& start, const Pose& goal,
                   const Trajectory& trajectory)
{
  const ExactPolygon body(grid, robot);
  EXPECT_LT(distance(trajectory.front().pose(), start), 1e-3);
  EXPECT_LT(distance(trajectory.back().pose(), goal), 1e-3);
  EXPECT_LT(heading_gap(trajectory.back().theta, goal.theta), 1e-3);
  const BaseLink base_link(robot);
  for (std::size_t i = 0; i + 1 < trajectory.size(); ++i)
  {
    ASSERT_FALSE(body.collides(trajectory[i].pose())) << "point " << i << " at " << text(trajectory[i].pose());
    const TrajectoryPoint& p = trajectory[i];
    if (p.mode != trajectory[i + 1].mode) continue;
    const double half = (trajectory[i + 1].t - p.t) / 2.0;
    const Pose middle = base_link.from_centre(
        move(base_link.to_centre(p.pose()),
             body_twist(robot, p.mode, p.v + p.a * half / 2.0, p.phi + p.omega * half / 2.0), half));
    ASSERT_LT(body.overlap(middle), 2e-3) << "after point " << i;
  }
}

TEST(BaseLinkAtTheRearAxle, IsDrivenAsTheCentreIs)
{
  const OccupancyGrid grid = maze({3.0, -2.0, 0.4});
  const Pose start = compose(grid.origin, {0.8, 0.8, 0.0}), goal = compose(grid.origin, {11.0, 11.2, M_PI_2});
  const PlanResult of_centre = plan(grid, {}, start, goal);
  ASSERT_EQ(of_centre.status, PlanStatus::succeeded) << of_centre.message;
  Robot robot;
  robot.base_offset = {0.34, 0.0};
  const BaseLink base_link(robot);
  const PlanResult result = plan(grid, robot, base_link.from_centre(start), base_link.from_centre(goal));
  ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
  // Start and goal differ in their last digits.
  EXPECT_NEAR(result.metrics.arrival_time, of_centre.metrics.arrival_time, 1e-4 * of_centre.metrics.arrival_time);
  expect_driven(grid, robot, base_link.from_centre(start), base_link.from_centre(goal), result.trajectory);
  EXPECT_LT(distance(result.path.goal, goal), 1e-3) << "paths stay those of the centre";
}

TEST(BaseLinkAtTheRearAxle, IsWhatSentencesTell)
{
  Robot robot;
  robot.base_offset = {0.34, 0.0};
  const OccupancyGrid grid = free_area(8.0, 6.0, 0.05, {100.0, 50.0, 0.0});
  const PlanResult result = plan(grid, robot, {101.0, 53.0, 0.0}, {107.5, 53.0, 0.0});
  EXPECT_EQ(result.status, PlanStatus::goal_in_collision);
  EXPECT_TRUE(says(result.message, "the goal (107.500, 53.000, 0.000) is off the map"));
  // The other way round the front is within the map.
  EXPECT_TRUE(says(result.message, "the nearest free pose is 0.00 m away, turned by"));
}

TEST(BaseLinkAtTheRearAxle, IsWhatAChangedMapIsHeldAgainst)
{
  Robot robot;
  robot.base_offset = {0.34, 0.0};
  OccupancyGrid grid = free_area(8.0, 4.0, 0.05);
  const PlannerOptions options = patient();
  const World before(grid, robot, options);
  const PlanResult result = Planner(options).plan(before, {{1.0, 2.0, 0.0}, {6.0, 2.0, 0.0}, {}});
  ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
  EXPECT_FALSE(before.first_violation_from(0.0, result.trajectory).has_value());
  // The front comes to 6.84 m.
  occupy_block(grid, 137, 40, 2, 2);
  EXPECT_FALSE(World(grid, robot, options).first_violation_from(0.0, result.trajectory).has_value());
  occupy_block(grid, 136, 40, 2, 2);
  EXPECT_TRUE(World(grid, robot, options).first_violation_from(0.0, result.trajectory).has_value());
}

TEST(PolygonRobots, DriveThroughClutterWithoutTouchingIt)
{
  Random random(kSeed);
  int solved = 0;
  for (int k = 0; k < 25; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", map " + std::to_string(k));
    Robot robot = polygon_robot(random);
    if (k % 5 == 4)
    {
      robot = Robot();
      robot.body_offset = {random.between(-0.15, 0.15), random.between(-0.04, 0.04)};
      robot.base_offset = {random.unit(), random.unit()};
    }
    const OccupancyGrid grid = clutter(random, 10.0, 0.05, 12, random.pose(30.0));
    const ExactPolygon body(grid, robot);
    const auto free_base = [&] {
      for (;;)
      {
        const Pose pose = compose(grid.origin, {random.between(0.0, 10.0), random.between(0.0, 10.0), random.angle()});
        if (!body.collides(pose)) return pose;
      }
    };
    const Pose start = free_base(), goal = free_base();
    const PlanResult result = plan(grid, robot, start, goal);
    if (result.status == PlanStatus::goal_unreachable || result.status == PlanStatus::no_path) continue;
    ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
    expect_driven(grid, robot, start, goal, result.trajectory);
    ++solved;
  }
  EXPECT_GE(solved, 18);
}

/// Corridors that its bounding rectangle does not fit into at any heading that it has to have.
TEST(PolygonRobots, GoWhereOnlyTheirShapeFits)
{
  Robot robot;  // A hexagon: 1.3 m long with its tips, 0.62 m wide.
  robot.footprint = {{0.75, 0.0}, {0.4, 0.31}, {-0.4, 0.31}, {-0.75, 0.0}, {-0.4, -0.31}, {0.4, -0.31}};
  robot.safety_margin = 0.0;
  OccupancyGrid grid = free_area(8.0, 6.0, 0.01);
  // A corner of 1.12 m width: the rectangle around the hexagon would need 1.2 m to turn.
  occupy_block(grid, 0, 0, 800, 100);
  occupy_block(grid, 0, 212, 344, 388);
  occupy_block(grid, 456, 212, 344, 388);
  const PlanResult result = plan(grid, robot, {1.0, 1.56, 0.0}, {4.0, 5.0, M_PI_2});
  ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
  expect_driven(grid, robot, {1.0, 1.56, 0.0}, {4.0, 5.0, M_PI_2}, result.trajectory);
}

TEST(PolygonRobots, AreNoneForThePapersFormulation)
{
  if (!has_ipopt()) GTEST_SKIP() << "built without Ipopt";
  Robot robot;
  robot.body_offset = {0.1, 0.0};
  PlannerOptions options = patient();
  options.optimize.formulation = Formulation::paper;
  options.optimize.solver = NlpSolver::ipopt;
  const PlanResult result =
      Planner(options).plan(World(free_area(8.0, 6.0, 0.05), robot, options), {{2.0, 3.0, 0.0}, {6.0, 3.0, 0.0}, {}});
  EXPECT_EQ(result.status, PlanStatus::invalid_input);
  EXPECT_TRUE(says(result.message, "the centre of the wheels"));
}

}  // namespace
}  // namespace fourwis
