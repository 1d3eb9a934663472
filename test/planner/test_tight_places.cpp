#include <gtest/gtest.h>

#include "../support/grids.h"
#include "../support/path_laws.h"
#include "../support/rectangle.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 23;

/// Places where the body fits and the paper's two discs do not.
struct TightPlaces : testing::Test
{
  TightPlaces() { options.planner_patience = 60.0; }

  PlanResult plan(const World& world, const Pose& start, const Pose& goal) const
  {
    return Planner(options).plan(world, {start, goal, {}});
  }

  static void expect_clear(const OccupancyGrid& grid, const Robot& robot, const Trajectory& trajectory)
  {
    const ExactRectangle rectangle(grid, robot);
    for (const TrajectoryPoint& point : trajectory)
      ASSERT_FALSE(rectangle.collides(point.pose())) << text(point.pose());
  }

  /// A hall of 8 m by 6 m that a wall divides, with a gap of the given width [m] in the middle.
  static OccupancyGrid divided_hall(double gap)
  {
    OccupancyGrid grid = free_area(8.0, 6.0, 0.01);
    occupy_block(grid, 390, 0, 20, 600);
    const int half = static_cast<int>(std::lround(gap * 50));
    for (int row = 300 - half; row < 300 + half; ++row)
      for (int column = 390; column < 410; ++column) cell(grid, column, row) = 0;
    return grid;
  }

  const Robot robot;
  PlannerOptions options;
  const Pose here = {2.0, 3.0, 0.3}, there = {6.0, 3.0, -0.5};
};

/// A robot that is stopped on its way and sent elsewhere has a plan: also where trajectories cut corners closer than two
/// discs can, and with the tracking error on top.
TEST_F(TightPlaces, TheRobotCanGoOnFromWhereverItsTrajectoriesBringIt)
{
  Random random(kSeed);
  int tight = 0;
  for (int k = 0; k < 12; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", map " + std::to_string(k));
    const OccupancyGrid grid = clutter(random, 8.0, 0.05, 14);
    const World world(grid, robot, options);
    const CollisionChecker two_discs(world.obstacles, robot);
    const Pose goal = free_pose(random, two_discs);
    const PlanResult whole = plan(world, free_pose(random, two_discs), goal);
    if (whole.status != PlanStatus::succeeded) continue;
    for (std::size_t i = 1; i + 1 < whole.trajectory.size(); i += 6)
    {
      const Pose error = {random.between(-0.004, 0.004), random.between(-0.004, 0.004), random.between(-0.005, 0.005)};
      const Pose stop = compose(whole.trajectory[i].pose(), error);
      const PlanResult rest = plan(world, stop, goal);
      ASSERT_EQ(rest.status, PlanStatus::succeeded) << text(stop) << ": " << rest.message;
      expect_clear(grid, robot, rest.trajectory);
      tight += !two_discs.is_free(stop);
    }
  }
  EXPECT_GT(tight, 10) << "stops where two discs do not fit";
}

TEST_F(TightPlaces, GoesThroughGapsThatOnlyTheBodyFits)
{
  for (double gap : {0.84, 0.80, 0.76, 0.72, 0.70})
  {
    SCOPED_TRACE("a gap of " + std::to_string(gap) + " m");
    const OccupancyGrid grid = divided_hall(gap);
    const PlanResult result = plan(World(grid, robot, options), here, there);
    ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
    expect_clear(grid, robot, result.trajectory);
  }
}

TEST_F(TightPlaces, SaysThatAGapNarrowerThanTheBodyIsNoWay)
{
  for (double gap : {0.0, 0.3, 0.56, 0.62})
  {
    const PlanResult result = plan(World(divided_hall(gap), robot, options), here, there);
    EXPECT_STREQ(to_string(result.status), "goal_unreachable") << gap;
  }
}

TEST_F(TightPlaces, ParksBesideAWallAndLeaves)
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.01);
  occupy_block(grid, 0, 0, 800, 100);
  const World world(grid, robot, options);
  const Pose parked = {5.0, 1.0 + robot.width / 2.0 + 0.05, 0.0};
  ASSERT_FALSE(CollisionChecker(world.obstacles, robot).is_free(parked));
  for (const auto& [start, goal] : {std::pair(here, parked), std::pair(parked, here)})
  {
    const PlanResult result = plan(world, start, goal);
    ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
    expect_clear(grid, robot, result.trajectory);
  }
}

TEST_F(TightPlaces, RefusesToStartInContactAndSaysByHowMuch)
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.01);
  occupy_block(grid, 0, 0, 800, 100);
  const PlanResult result = plan(World(grid, robot, options), {5.0, 1.0 + robot.width / 2.0 - 0.04, 0.0}, there);
  EXPECT_STREQ(to_string(result.status), "start_in_collision");
  EXPECT_NE(result.message.find("the body overlaps an obstacle by 0.040 m"), std::string::npos) << result.message;
}

}  // namespace
}  // namespace fourwis
