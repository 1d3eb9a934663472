#include "planner/grid_frame.h"

#include <gtest/gtest.h>

#include "../support/random.h"
#include "../support/rectangle.h"
#include "hall.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 81;
const Pose kStart = {0.8, 0.8, 0.0}, kGoal = {11.0, 11.2, M_PI_2};

PlanResult plan_maze(const Pose& origin, PlanTrace* trace = nullptr)
{
  PlannerOptions options;
  options.planner_patience = 60.0;
  const World world(maze(origin), {}, options);
  return Planner(options).plan(world, {compose(origin, kStart), compose(origin, kGoal), {}}, {}, trace);
}

/// What a double can tell apart at a place [m].
double grain(const Pose& origin)
{
  return 1e-9 + 1e-15 * std::max(std::abs(origin.x), std::abs(origin.y));
}

/// Path, expanded poses and regions lie where the grid is.
void expect_shown(const Pose& origin, const PlanResult& result, const PlanTrace& trace)
{
  const auto is_near = [&](const Pose& pose, const Pose& in_grid) {
    return distance(pose, compose(origin, in_grid)) < 1e-3 + 3.0 * grain(origin);
  };
  EXPECT_TRUE(is_near(result.path.pieces.front().start, kStart));
  EXPECT_TRUE(is_near(result.path.goal, kGoal));
  EXPECT_TRUE(is_near(result.trajectory.front().pose(), kStart));
  EXPECT_TRUE(is_near(result.trajectory.back().pose(), kGoal));
  ASSERT_FALSE(trace.expanded.empty());
  EXPECT_TRUE(is_near(trace.expanded.front(), kStart));
  for (const Pose& pose : trace.expanded)
  {
    const Pose in_grid = relative_to(origin, pose);
    ASSERT_TRUE(in_grid.x > 0.0 && in_grid.y > 0.0 && in_grid.x < 12.0 && in_grid.y < 12.0) << text(in_grid);
  }
  ASSERT_FALSE(trace.rounds.empty());
  // Regions hold the disc centres of the points next to them.
  for (const std::vector<RefinementRound>& rounds : trace.rounds)
    for (const DiscRegions& disc : rounds.back().corridor)
      for (std::size_t k = 0; k < disc.regions.size(); ++k)
      {
        const Pose centre = compose(rounds.back().points[k].pose(), {disc.centre.x, disc.centre.y, 0.0});
        // c grows with the distance from the origin and with it its rounding.
        for (const HalfPlane& plane : disc.regions[k])
          ASSERT_LE(plane.a * centre.x + plane.b * centre.y, plane.c + 0.05 + 10.0 * grain(origin));
      }
}

struct MazeFarAway : testing::TestWithParam<Pose>
{};

TEST_P(MazeFarAway, IsDrivenAsAtTheOriginAndShownWhereItIs)
{
  const Pose origin = GetParam();
  static const PlanResult here = plan_maze({});
  ASSERT_EQ(here.status, PlanStatus::succeeded) << here.message;
  PlanTrace trace;
  const PlanResult there = plan_maze(origin, &trace);
  ASSERT_EQ(there.status, PlanStatus::succeeded) << there.message;
  EXPECT_NEAR(there.metrics.arrival_time, here.metrics.arrival_time, 1e-4 * here.metrics.arrival_time);
  EXPECT_EQ(there.fallback_parts, 0);
  const OccupancyGrid grid = maze(origin);
  const ExactRectangle body(grid, {});
  const Trajectory& points = there.trajectory;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_LE(body.depth(points[i].pose()), 3.0 * grain(origin)) << "point " << i;
    ASSERT_LT(std::abs(points[i].theta - points[i > 0 ? i - 1 : 0].theta), 1.0)
        << "headings must not jump by a full turn";
  }
  expect_shown(origin, there, trace);
}

INSTANTIATE_TEST_SUITE_P(Origins, MazeFarAway,
                         testing::Values(Pose{453211.37, 5400000.0, 0.0}, Pose{4508927511.5, -5511483896.25, 0.0},
                                         Pose{-3.0, 7.0, 0.5}, Pose{453211.37, 5400000.0, -2.2}, Pose{0.0, 0.0, M_PI_2},
                                         Pose{12.5, -4.0, 3.0 * M_PI}));

TEST(GridFrame, OfAnOriginOfZeroChangesNoBit)
{
  Random random(kSeed);
  const GridFrame frame{Pose{}, Robot()};
  for (int k = 0; k < 1000; ++k)
  {
    const Pose pose = random.pose(100.0);
    for (const Pose& same : {frame.to_grid(pose), frame.to_map(pose)})
    {
      ASSERT_EQ(same.x, pose.x);
      ASSERT_EQ(same.y, pose.y);
      ASSERT_EQ(same.theta, pose.theta);
    }
  }
}

TEST(GridFrame, ThereAndBackIsTheSamePose)
{
  Random random(kSeed);
  for (int k = 0; k < 1000; ++k)
  {
    Robot robot;
    robot.base_offset = {random.unit(), random.unit()};
    const GridFrame frame(random.pose(1e6), robot);
    const Pose pose = random.pose(20.0), back = frame.to_grid(frame.to_map(pose));
    ASSERT_LT(distance(back, pose), 1e-8);
    ASSERT_NEAR(back.theta, pose.theta, 1e-12);
  }
}

TEST(WorldOnATurnedGrid, HoldsATrajectoryOfTheMapFrameAgainstItsObstacles)
{
  const Pose origin = {300.0, -50.0, 2.0};
  const PlannerOptions options;
  OccupancyGrid grid = free_area(8.0, 4.0, 0.05, origin);
  const World before(grid, {}, options);
  const PlanResult result =
      Planner(options).plan(before, {compose(origin, {1.0, 2.0, 0.0}), compose(origin, {7.0, 2.0, 0.0}), {}});
  ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
  EXPECT_FALSE(before.first_violation_from(0.0, result.trajectory).has_value());
  occupy_block(grid, 80, 40, 2, 2);
  const World after(grid, {}, options);
  const std::optional<Violation> found = after.first_violation_from(0.0, result.trajectory);
  ASSERT_TRUE(found.has_value());
  // The front, half a metre ahead, meets the post at x = 4 m after 2.5 m.
  EXPECT_NEAR(found->t, 2.5 + 0.1, 0.15);
  double x, y;
  ASSERT_EQ(std::sscanf(found->what.c_str(), "collision: the body at (%lf m, %lf m", &x, &y), 2) << found->what;
  const Pose named = relative_to(origin, {x, y, 0.0});
  EXPECT_NEAR(named.x, 3.5, 0.1) << "the map frame's numbers are told";
  EXPECT_NEAR(named.y, 2.0, 0.1);
  EXPECT_FALSE(after.first_violation_from(6.0, result.trajectory).has_value());
}

}  // namespace
}  // namespace fourwis
