// Paths that make no sense: the back end answers with what the referee can refuse or accept, and comes back.

#include <gtest/gtest.h>

#include <limits>

#include "../segment/random_path.h"
#include "../support/grids.h"
#include "fourwis_navigation/planner/planner.h"
#include "fourwis_navigation/referee/referee.h"
#include "planner/back_end.h"

namespace fourwis
{
namespace
{

constexpr double kSpeed = 1.0;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

/// A hall of 12 m x 8 m with a block in its middle.
OccupancyGrid hall()
{
  OccupancyGrid grid = free_area(12.0, 8.0, 0.05);
  occupy_block(grid, 110, 70, 20, 20);
  return grid;
}

struct BackEndGarbage : testing::Test
{
  Refinement refine(const Path& path, const Robot& with) const
  {
    const CollisionChecker checker(map, with);
    Refinement refinement = fourwis::refine(checker, obstacles, with, OptimizeOptions(), kSpeed, path, {});
    polish(checker, obstacles, with, OptimizeOptions(), kSpeed, {}, refinement);
    return refinement;
  }
  Refinement refine(const Path& path) const { return refine(path, robot); }

  Verdict judge(const Path& path) const
  {
    return Referee(grid, ObstacleRule(), robot).judge(path.pieces.front().start, path.goal, refine(path).trajectory);
  }

  const Robot robot;
  const OccupancyGrid grid = hall();
  const ObstacleMap map{grid};
  const ObstacleRectangles obstacles{map};
};

TEST_F(BackEndGarbage, NothingToDriveIsAnEmptyTrajectory)
{
  EXPECT_TRUE(refine({}).trajectory.empty());
}

TEST_F(BackEndGarbage, PiecesWithoutLengthAndSwitchesInARowAreDriven)
{
  Path path = path_from({2.0, 2.0, 0.0});
  append(path, robot, Mode::ackermann, 0.1, 1.0);
  append(path, robot, Mode::ackermann, 0.1, 0.0);  // a point twice
  append(path, robot, Mode::lateral, 0.0, 0.0);    // two switches in a row
  append(path, robot, Mode::parallel, 0.5, 0.0);
  append(path, robot, Mode::ackermann, -0.2, 1.0);
  const Verdict verdict = judge(path);
  EXPECT_TRUE(verdict.accepted()) << verdict.violations.front().what;
}

TEST_F(BackEndGarbage, AMillimetreIsDriven)
{
  for (Mode mode : kPlannedModes)
    for (double phi : {0.0, 0.3})
    {
      Path path = path_from({2.0, 2.0, 0.3});
      append(path, robot, mode, phi, 0.001);
      const Verdict verdict = judge(path);
      EXPECT_TRUE(verdict.accepted()) << to_string(mode) << ": " << verdict.violations.front().what;
    }
}

TEST_F(BackEndGarbage, WaypointsInAnObstacleOrOffTheMapAreLeftToTheReferee)
{
  Path through_block = path_from({3.0, 4.0, 0.0});
  append(through_block, robot, Mode::ackermann, 0.05, 3.0);
  append(through_block, robot, Mode::ackermann, -0.05, 3.0);
  Path off_map = path_from({10.0, 2.0, 0.0});
  append(off_map, robot, Mode::ackermann, 0.05, 2.0);
  append(off_map, robot, Mode::ackermann, -0.05, 2.0);
  for (const Path& path : {through_block, off_map})
  {
    const Refinement refinement = refine(path);
    EXPECT_EQ(refinement.fallbacks, 1);
    EXPECT_NE(refinement.message.find("meets an obstacle or the map's border"), std::string::npos)
        << refinement.message;
    EXPECT_FALSE(judge(path).accepted());
  }
}

TEST_F(BackEndGarbage, NumbersThatAreNoneAreNeverOptimised)
{
  for (double bad : {kNaN, kInfinity, -kInfinity})
    for (double PathPiece::*number : {&PathPiece::phi, &PathPiece::length})
    {
      Path path = path_from({2.0, 2.0, 0.0});
      append(path, robot, Mode::ackermann, 0.1, 1.0);
      append(path, robot, Mode::ackermann, -0.1, 1.0);
      path.pieces[1].*number = bad;
      const Refinement refinement = refine(path);
      for (const RefinedPart& part : refinement.parts) EXPECT_FALSE(part.optimized);
      EXPECT_FALSE(judge(path).accepted());
    }
}

/// Robots are checked where they are read; this is what happens if one gets past.
TEST_F(BackEndGarbage, LimitsOfZeroOrInfinityComeBackWithSomething)
{
  for (double Robot::*limit : {&Robot::max_speed, &Robot::max_acceleration, &Robot::max_steering_rate,
                               &Robot::wheel_max_rate, &Robot::wheel_max_speed, &Robot::max_steering_angle})
    for (double bad : {0.0, kInfinity, kNaN})
    {
      Robot limited;
      limited.*limit = bad;
      const World world(grid, robot, PlannerOptions());
      PlannerOptions options;
      options.planner_patience = 2.0;
      const PlanResult result = Planner(limited, options).plan(world, {{2.0, 2.0, 0.0}, {4.0, 2.5, 0.3}, {}});
      if (result.status == PlanStatus::succeeded)
        EXPECT_TRUE(world.referee.judge({2.0, 2.0, 0.0}, {4.0, 2.5, 0.3}, result.trajectory).accepted());
      else
        EXPECT_FALSE(result.message.empty());
    }
}

}  // namespace
}  // namespace fourwis
