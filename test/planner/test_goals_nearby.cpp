#include <atomic>
#include <cmath>
#include <limits>

#include "planner/goals_nearby.h"
#include "planner_fixture.h"

namespace fourwis
{
namespace
{

using GoalsNearby = PlannerFixture;

/// A hall of 8 x 6 m with a block of 1 m around (6, 3), in a map that lies anywhere.
OccupancyGrid hall_with_a_block(const Pose& origin = {})
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.1, origin);
  occupy_block(grid, 55, 25, 10, 10);
  return grid;
}

PlanRequest request_with(const Pose& start, const Pose& goal, double tolerance)
{
  PlanRequest request{start, goal, {}, true};
  request.goal_tolerance = tolerance;
  return request;
}

Pose reached(const PlanResult& result)
{
  return result.trajectory.empty() ? Pose{} : result.trajectory.back().pose();
}

TEST(LatticeAround, IsAllWithinTheRadiusNearestFirst)
{
  const std::vector<Point2> offsets = lattice_around(0.5, 0.1);
  EXPECT_EQ(offsets.size(), 80u) << "points of the lattice in a circle of 5 steps, but for its centre";
  double before = 0.0;
  for (const Point2& offset : offsets)
  {
    const double now = std::hypot(offset.x, offset.y);
    EXPECT_LE(before, now + 1e-12);
    EXPECT_LE(now, 0.5 + 1e-12);
    EXPECT_GE(now, 0.1 - 1e-12);
    before = now;
  }
  // Of the four nearest, by direction: behind at pi is the last, because atan2 has it so.
  const std::vector<Point2> nearest = {{0.0, -0.1}, {0.1, 0.0}, {0.0, 0.1}, {-0.1, 0.0}};
  for (std::size_t i = 0; i < nearest.size(); ++i)
  {
    EXPECT_DOUBLE_EQ(offsets[i].x, nearest[i].x) << i;
    EXPECT_DOUBLE_EQ(offsets[i].y, nearest[i].y) << i;
  }
}

TEST(LatticeAround, TakesAShortRadiusForTheStep)
{
  const std::vector<Point2> offsets = lattice_around(0.03, 0.1);
  ASSERT_EQ(offsets.size(), 4u);
  for (const Point2& offset : offsets) EXPECT_DOUBLE_EQ(std::hypot(offset.x, offset.y), 0.03);
  EXPECT_TRUE(lattice_around(0.0, 0.1).empty());
}

TEST(LatticeAround, IsBoundedForEveryRadius)
{
  for (const double radius : {3.0, 1e3, 1e30, std::numeric_limits<double>::max()})
  {
    const std::vector<Point2> offsets = lattice_around(radius, 0.01);
    EXPECT_GT(offsets.size(), 1900u) << radius;
    EXPECT_LT(offsets.size(), 2000u) << radius;
  }
}

TEST_F(GoalsNearby, AreFreeAndKeepTheHeading)
{
  const World world(hall_with_a_block(), robot, options);
  const PlanRequest request = request_with(here, {6.0, 3.0, 0.5}, 1.5);
  const std::vector<Pose> goals = free_goals_nearby(world, options, request);
  ASSERT_FALSE(goals.empty());
  for (const Pose& goal : goals)
  {
    EXPECT_EQ(goal.theta, 0.5);
    EXPECT_LE(distance(goal, request.goal), 1.5 + 1e-9);
    EXPECT_FALSE(goal.x > 5.5 && goal.x < 6.5 && goal.y > 2.5 && goal.y < 3.5) << "C in the block";
  }
  EXPECT_GT(distance(goals.front(), request.goal), 0.5 + 0.31) << "half the block and half the width of the body";
}

TEST_F(GoalsNearby, WithoutToleranceAGoalInAnObstacleIsRefused)
{
  const World world(hall_with_a_block(), robot, options);
  expect_refused(plan(world, request_with(here, {6.0, 3.0, 0.0}, 0.0)), PlanStatus::goal_in_collision);
}

TEST_F(GoalsNearby, AGoalThatHasAPlanIsNotMoved)
{
  const World world(hall_with_a_block(), robot, options);
  const PlanResult exact = plan(world, request_with(here, {4.0, 3.0, 0.0}, 0.0)),
                   relaxed = plan(world, request_with(here, {4.0, 3.0, 0.0}, 1.0));
  EXPECT_EQ(relaxed.status, PlanStatus::succeeded) << relaxed.message;
  EXPECT_EQ(relaxed.message, exact.message);
  EXPECT_EQ(relaxed.trajectory.size(), exact.trajectory.size());
  EXPECT_LT(distance(reached(relaxed), {4.0, 3.0, 0.0}), 1e-3);
}

TEST_F(GoalsNearby, TheNearestThatHasAPlanStandsInForAGoalInAnObstacle)
{
  for (const Pose& origin : {Pose{}, Pose{-20.0, 7.0, 1.2}})
  {
    const World world(hall_with_a_block(origin), robot, options);
    const PlanRequest in_grid = request_with(here, {6.0, 3.0, 0.0}, 1.5);
    PlanRequest request = in_grid;
    request.start = compose(origin, in_grid.start);
    request.goal = compose(origin, in_grid.goal);
    const PlanResult result = plan(world, request);
    ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
    const std::vector<Pose> goals = free_goals_nearby(world, options, in_grid);
    EXPECT_LT(distance(reached(result), compose(origin, goals.front())), 1e-3);
    EXPECT_NEAR(wrap_angle(reached(result).theta - request.goal.theta), 0.0, 1e-3);
    EXPECT_NE(result.message.find("m from a goal that is goal_in_collision"), std::string::npos) << result.message;
  }
}

TEST_F(GoalsNearby, PosesThatCannotBeReachedArePassedOver)
{
  // The goal lies in a closed chamber of 2 x 2 m, whose other poses are nearer than those outside.
  OccupancyGrid grid = free_area(10.0, 6.0, 0.1);
  wall_in(grid, 60, 20, 20, 20);
  const World world(grid, robot, options);
  const PlanRequest near = request_with({2.0, 3.0, 0.0}, {6.9, 3.0, 0.0}, 0.5);
  const PlanResult shut_in = plan(world, near);
  expect_refused(shut_in, PlanStatus::goal_unreachable);
  EXPECT_NE(shut_in.message.find("free poses within 0.5 m"), std::string::npos) << shut_in.message;
  const PlanResult outside = plan(world, request_with(near.start, near.goal, 2.0));
  ASSERT_EQ(outside.status, PlanStatus::succeeded) << outside.message;
  const Pose end = reached(outside);
  EXPECT_FALSE(end.x > 6.0 && end.x < 8.0 && end.y > 2.0 && end.y < 4.0) << "in the chamber";
  EXPECT_LE(distance(end, near.goal), 2.0 + 1e-3);
}

TEST_F(GoalsNearby, AStartInAnObstacleIsNotTheGoalsFault)
{
  const World world(hall_with_a_block(), robot, options);
  expect_refused(plan(world, request_with({6.0, 3.0, 0.0}, here, 2.0)), PlanStatus::start_in_collision);
}

TEST_F(GoalsNearby, TimeAndCancelEndTheSearchForOne)
{
  const World world(hall_with_a_block(), robot, options);
  const PlanRequest request = request_with(here, {6.0, 3.0, 0.0}, 1.5);
  const std::atomic<bool> cancelled{true};
  expect_refused(plan(world, request, Interrupt(&cancelled)), PlanStatus::cancelled);
  expect_refused(plan(world, request, Interrupt(nullptr, Interrupt::Clock::now())), PlanStatus::timeout);
}

TEST_F(GoalsNearby, AToleranceThatIsNoneIsRefusedInASentence)
{
  for (const double bad : {-0.1, std::nan(""), std::numeric_limits<double>::infinity()})
  {
    const PlanResult result =
        plan(World(hall_with_a_block(), robot, options), request_with(here, {4.0, 3.0, 0.0}, bad));
    expect_refused(result, PlanStatus::invalid_input);
    EXPECT_NE(result.message.find("tolerance is"), std::string::npos) << result.message;
    EXPECT_NE(result.message.find("expected a finite number from 0"), std::string::npos) << result.message;
  }
}

TEST_F(GoalsNearby, AGoalFarOffTheMapWithAHugeToleranceIsAnsweredAtTheMap)
{
  const World world(hall_with_a_block(), robot, options);
  for (const double far : {12.0, 1e6, 1e300})
  {
    const PlanResult result = plan(world, request_with(here, {far, 3.0, 0.0}, 3e38));
    EXPECT_TRUE(result.status == PlanStatus::succeeded || result.status == PlanStatus::goal_in_collision)
        << result.message;
  }
}

}  // namespace
}  // namespace fourwis
