// What the planner refuses and rejects, and what it answers when its time is over.

#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "planner/back_end.h"
#include "planner_fixture.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 15;

using PlannerRefusals = PlannerFixture;

TEST_F(PlannerRefusals, RefusesNumbersThatAreNone)
{
  for (double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
    for (const Pose& pose : {Pose{bad, 3.0, 0.0}, Pose{2.0, bad, 0.0}, Pose{2.0, 3.0, bad}})
    {
      expect_refused(plan_in_hall(pose, there), PlanStatus::invalid_input);
      expect_refused(plan_in_hall(here, pose), PlanStatus::invalid_input);
    }
}

TEST_F(PlannerRefusals, RefusesToPlanInNoMode)
{
  expect_refused(plan_in_hall(here, there, ModeSet::none()), PlanStatus::invalid_input);
}

TEST_F(PlannerRefusals, RefusesStartsAndGoalsOffTheMap)
{
  for (const Pose& off :
       {Pose{-5.0, 3.0, 0.0}, Pose{2.0, 6.5, 0.0}, Pose{1e9, 1e9, 0.0}, Pose{1e300, -1e300, 0.0}, Pose{0.1, 3.0, 0.0}})
  {
    expect_refused(plan_in_hall(off, there), PlanStatus::start_in_collision);
    expect_refused(plan_in_hall(here, off), PlanStatus::goal_in_collision);
  }
}

TEST_F(PlannerRefusals, RefusesStartsAndGoalsInObstacles)
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.1);
  occupy_block(grid, 58, 28, 3, 3);
  const World world(grid, robot, options);
  expect_refused(plan(world, {there, here, {}}), PlanStatus::start_in_collision);
  expect_refused(plan(world, {here, there, {}}), PlanStatus::goal_in_collision);
}

TEST_F(PlannerRefusals, TakesUnknownCellsForObstaclesUnlessToldOtherwise)
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.1);
  for (int row = 0; row < 60; ++row) cell(grid, 40, row) = -1;
  expect_refused(plan(World(grid, robot, options), {here, there, {}}), PlanStatus::goal_unreachable);
  options.obstacles.unknown_is_obstacle = false;
  EXPECT_EQ(plan(World(grid, robot, options), {here, there, {}}).status, PlanStatus::succeeded);
}

TEST_F(PlannerRefusals, RefusesAGoalThatIsWalledIn)
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.05);
  wall_in(grid, 90, 30, 60, 60);
  const World world(grid, robot, options);
  expect_refused(plan(world, {here, there, {}}), PlanStatus::goal_unreachable);
  expect_refused(plan(world, {there, here, {}}), PlanStatus::goal_unreachable);
}

TEST_F(PlannerRefusals, TimesOutWhenItsPatienceIsOver)
{
  // A flood of the whole hall, tens of milliseconds.
  options.planner_patience = 0.001;
  options.search.terminal_connection = false;
  options.search.heuristic_weight = 0.0;
  options.search.max_expansions = 1000000;
  expect_refused(plan_in_hall(here, there), PlanStatus::timeout);
}

TEST_F(PlannerRefusals, TimesOutAtTheCallersDeadline)
{
  expect_refused(plan_in_hall(here, there, {}, Interrupt(nullptr, Interrupt::Clock::now())), PlanStatus::timeout);
}

TEST_F(PlannerRefusals, StopsWhenCancelled)
{
  const std::atomic<bool> cancelled{true};
  expect_refused(plan_in_hall(here, there, {}, Interrupt(&cancelled)), PlanStatus::cancelled);
}

TEST_F(PlannerRefusals, AnswersWithTheBestItHasWhenItsPatienceIsOver)
{
  Random random(kSeed);
  const World world(clutter(random, 12.0, 0.05, 14), robot, options);
  const CollisionChecker checker(world.obstacles, robot);
  PlanRequest request;
  PlanResult full;
  while (full.status != PlanStatus::succeeded)
  {
    request = {free_pose(random, checker), free_pose(random, checker), {}};
    full = plan(world, request);
  }
  // Wherever the deadline falls: in the search, in some round of some candidate, or after all of it.
  for (double patience = 1e-4; patience < 1.0; patience *= 1.1)
  {
    const PlanResult result = plan(world, request, Interrupt().or_after(patience));
    if (result.status == PlanStatus::timeout)
    {
      EXPECT_TRUE(result.trajectory.empty());
      continue;
    }
    EXPECT_EQ(result.status, PlanStatus::succeeded) << result.message;
    EXPECT_TRUE(world.referee.judge(request.start, request.goal, result.trajectory).accepted());
  }
}

TEST_F(PlannerRefusals, AnswersWithAllItsStopsWhenTheTimeIsOverAfterTheSearch)
{
  const World world(free_area(8.0, 6.0, 0.1), robot, options);
  const Path path = plan(world, {{1.0, 1.0, 0.0}, {6.0, 4.0, 1.0}, {}}).path;
  const CollisionChecker checker(world.obstacles, robot);
  ThreadBudget threads;
  const Interrupt at_once(nullptr, Interrupt::Clock::now());
  const Refinement late = BackEnd({world, options, checker, at_once, threads}).refine(path);
  EXPECT_TRUE(world.referee.judge({1.0, 1.0, 0.0}, {6.0, 4.0, 1.0}, late.trajectory).accepted());
}

TEST_F(PlannerRefusals, DoesNotPublishWhatTheRefereeRefusesOfThePapersBackEnd)
{
  if (!has_ipopt()) GTEST_SKIP();
  options.optimize.solver = NlpSolver::ipopt;
  options.optimize.formulation = Formulation::paper;
  options.search.steering_penalty = 0.0;
  const World world(free_area(8.0, 6.0, 0.1), robot, options);
  const PlanResult bent = plan(world, {{1.0, 1.0, 0.0}, {6.0, 4.0, 1.5}, ModeSet{Mode::ackermann}});
  EXPECT_EQ(bent.status, PlanStatus::verification_failed) << bent.message;
  EXPECT_NE(bent.message.find("rolled-out"), std::string::npos) << bent.message;
  EXPECT_TRUE(bent.trajectory.empty());
  EXPECT_GT(bent.metrics.arrival_time, 5.0);
  EXPECT_FALSE(bent.metrics.safe);
}

TEST_F(PlannerRefusals, RejectsThePapersFormulationOnTheStructuredSolver)
{
  if (!has_ipopt()) GTEST_SKIP();
  options.optimize.formulation = Formulation::paper;
  try
  {
    Planner{options};
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(),
                 "parameter 'solver' is 'structured', expected 'ipopt' where 'formulation' is 'paper': the structured "
                 "solver has no penalties");
  }
}

TEST_F(PlannerRefusals, IpoptIsRejectedByNameOnlyWhereItIsNotBuiltIn)
{
  PlannerOptions solver, paper;
  solver.optimize.solver = paper.optimize.solver = NlpSolver::ipopt;
  paper.optimize.formulation = Formulation::paper;
  const auto rejection = [](const PlannerOptions& changed) -> std::string {
    try
    {
      Planner{changed};
      return "";
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
  };
  const std::string why = ": this program was built without Ipopt";
  EXPECT_EQ(rejection(solver), has_ipopt() ? "" : "parameter 'solver' is 'ipopt', expected 'structured'" + why);
  EXPECT_EQ(rejection(paper), has_ipopt() ? "" : "parameter 'formulation' is 'paper', expected 'default'" + why);
}

TEST_F(PlannerRefusals, RejectsLessThanOneThread)
{
  for (int none : {0, -1})
  {
    try
    {
      Planner(options, none);
      FAIL();
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_EQ(error.what(), "threads is " + std::to_string(none) + ", expected 1 or more");
    }
  }
}

TEST_F(PlannerRefusals, DoesNotBuildAWorldFromABadGrid)
{
  OccupancyGrid short_of_data = free_area(8.0, 6.0, 0.1), flat = short_of_data, nowhere = short_of_data;
  short_of_data.data.pop_back();
  flat.resolution = 0.0;
  nowhere.origin.theta = std::nan("");
  for (const OccupancyGrid& grid : {OccupancyGrid(), short_of_data, flat, nowhere})
    EXPECT_THROW(World(grid, robot, options), std::invalid_argument);
}

}  // namespace
}  // namespace fourwis
