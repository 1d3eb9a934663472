// Paths that make no sense: the back end answers with what the referee can refuse or accept, and comes back.

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <utility>

#include "../segment/random_path.h"
#include "../support/grids.h"
#include "fourwis_navigation/planner/planner.h"
#include "planner/back_end.h"

namespace fourwis
{
namespace
{

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
  Refinement refine(const Path& path)
  {
    const BackEnd back_end({world, options, checker, {}, threads});
    Refinement refinement = back_end.refine(path);
    back_end.polish(refinement);
    return refinement;
  }

  Verdict judge(const Path& path)
  {
    return world.referee.judge(path.pieces.front().start, path.goal, refine(path).trajectory);
  }

  const Robot robot;
  const PlannerOptions options;
  const World world{hall(), robot, options};
  const CollisionChecker checker{world.obstacles, world.robot};
  ThreadBudget threads;
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

/// Robots are checked where they are read. This is what happens if one gets past: no world takes it, or a plan for it comes
/// back with something.
TEST_F(BackEndGarbage, LimitsOfZeroOrInfinityAreRefusedOrComeBackWithSomething)
{
  PlannerOptions hasty;
  hasty.planner_patience = 2.0;
  for (const auto& [name, limit] : {std::pair("max_speed", &Robot::max_speed),
                                    {"max_acceleration", &Robot::max_acceleration},
                                    {"max_steering_rate", &Robot::max_steering_rate},
                                    {"wheel_max_rate", &Robot::wheel_max_rate},
                                    {"wheel_max_speed", &Robot::wheel_max_speed},
                                    {"max_steering_angle", &Robot::max_steering_angle}})
    for (double bad : {0.0, kInfinity, kNaN})
    {
      SCOPED_TRACE(std::string(name) + " = " + std::to_string(bad));
      Robot limited;
      limited.*limit = bad;
      const PlanRequest request = {{2.0, 2.0, 0.0}, {4.0, 2.5, 0.3}, {}};
      try
      {
        const World its_world(hall(), limited, hasty);
        const PlanResult result = Planner(hasty).plan(its_world, request);
        if (result.status == PlanStatus::succeeded)
          EXPECT_TRUE(its_world.referee.judge(request.start, request.goal, result.trajectory).accepted());
        else
          EXPECT_FALSE(result.message.empty());
      }
      catch (const std::invalid_argument& error)
      {
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      }
    }
}

}  // namespace
}  // namespace fourwis
