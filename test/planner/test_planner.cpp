// What the planner plans, and what it tells of it.

#include "../support/path_laws.h"
#include "planner_fixture.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 15;

struct PlannerTest : PlannerFixture
{
  /// Visits requests among clutter in all sets of modes, every other one for the front end alone, with what the planner
  /// answers.
  template <typename Visit>
  void for_plans(int count, Visit visit) const
  {
    Random random(kSeed);
    for (int k = 0; k < count; ++k)
    {
      const ModeSet modes = all_mode_sets()[static_cast<std::size_t>(k) % 7];
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", request " + std::to_string(k) + ", " + text(modes));
      const World world(clutter(random, 7.0, k % 2 ? 0.05 : 0.1, 7, random.pose(5.0)), robot, options);
      const CollisionChecker checker(world.obstacles, robot);
      // The obstacles are in the frame of the grid, the request is in the map frame.
      const Pose start = free_pose(random, checker);
      Pose goal = free_pose(random, checker);
      if (!modes.contains(Mode::ackermann) && !modes.contains(Mode::lateral)) goal.theta = start.theta;
      if (!checker.is_free(goal)) continue;
      PlanRequest request = {compose(world.grid.origin, start), compose(world.grid.origin, goal), modes};
      request.frontend_only = k % 2 == 1;
      visit(world, request, plan(world, request));
      if (HasFatalFailure()) return;
    }
  }
};

TEST_F(PlannerTest, SucceedsWithTrajectoriesThatAnyRefereeAccepts)
{
  int succeeded = 0;
  for_plans(56, [&](const World& world, const PlanRequest& request, const PlanResult& result) {
    if (result.status != PlanStatus::succeeded)
    {
      ASSERT_STRNE(to_string(result.status), to_string(PlanStatus::verification_failed)) << result.message;
      return;
    }
    ++succeeded;
    const Verdict verdict =
        Referee(world.grid, options.obstacles, robot).judge(request.start, request.goal, result.trajectory);
    ASSERT_TRUE(verdict.accepted()) << verdict.violations.front().what;
  });
  EXPECT_GT(succeeded, 35);
}

TEST_F(PlannerTest, ReportsMetricsThatAgreeWithEachOther)
{
  for_plans(28, [&](const World& world, const PlanRequest& request, const PlanResult& result) {
    if (result.status != PlanStatus::succeeded) return;
    const PlanMetrics& metrics = result.metrics;
    EXPECT_TRUE(metrics.safe);
    EXPECT_GE(metrics.length, distance(request.start, request.goal) - 1e-6);
    EXPECT_EQ(metrics.arrival_time, result.trajectory.back().t);
    EXPECT_GE(metrics.arrival_time, metrics.length / robot.max_speed - 1e-9);
    EXPECT_LE(metrics.mean_curvature, metrics.max_curvature);
    EXPECT_EQ(metrics.standard_mode_rate, 1.0);
    EXPECT_LT(metrics.terminal_position_error, 1e-3);
    EXPECT_LT(metrics.terminal_yaw_error, 1e-3);
    EXPECT_GE(metrics.min_clearance, 0.0);
    EXPECT_GE(metrics.total_ms, metrics.frontend_ms + metrics.backend_ms + metrics.verify_ms);
    EXPECT_GE(metrics.frontend_ms, metrics.map_ms);
    EXPECT_EQ(metrics.map_ms, world.build_ms);
    if (!request.frontend_only) return;
    // The path of arcs and straight lines is driven as it is.
    EXPECT_LE(metrics.length, result.path.length() + 1e-6);
    EXPECT_LE(metrics.max_curvature, max_curvature(robot, Mode::lateral) + 1e-6);
    EXPECT_EQ(metrics.switches, result.path.switches());
    EXPECT_EQ(metrics.outer_iterations, 0);
  });
}

TEST_F(PlannerTest, GivesTheSameTrajectoryEveryTime)
{
  for_plans(28, [&](const World& world, const PlanRequest& request, const PlanResult& result) {
    const PlanResult again = plan(World(world.grid, robot, options), request);
    ASSERT_EQ(again.status, result.status);
    ASSERT_EQ(again.message, result.message);
    ASSERT_EQ(again.trajectory.size(), result.trajectory.size());
    for (std::size_t i = 0; i < again.trajectory.size(); ++i)
    {
      ASSERT_EQ(again.trajectory[i].t, result.trajectory[i].t);
      ASSERT_TRUE(is_bitwise_equal(again.trajectory[i].pose(), result.trajectory[i].pose()));
    }
  });
}

TEST_F(PlannerTest, GivesTheSameTrajectoryWithAnyNumberOfThreads)
{
  for_plans(14, [&](const World& world, const PlanRequest& request, const PlanResult& result) {
    for (int threads : {1, 2, 8})
    {
      PlanTrace trace;
      const PlanResult again = Planner(options, threads).plan(world, request, {}, &trace);
      ASSERT_EQ(again.status, result.status);
      ASSERT_EQ(again.message, result.message);
      ASSERT_TRUE(is_bitwise_equal(again.path, result.path));
      ASSERT_EQ(again.metrics.ipopt_iterations, result.metrics.ipopt_iterations);
      ASSERT_EQ(again.metrics.expansions, result.metrics.expansions);
      ASSERT_EQ(again.trajectory.size(), result.trajectory.size());
      for (std::size_t i = 0; i < again.trajectory.size(); ++i)
      {
        ASSERT_EQ(again.trajectory[i].t, result.trajectory[i].t);
        ASSERT_TRUE(is_bitwise_equal(again.trajectory[i].pose(), result.trajectory[i].pose()));
      }
    }
  });
}

TEST_F(PlannerTest, PlansAcrossAHall)
{
  for (const ModeSet& modes : all_mode_sets())
  {
    if (!modes.contains(Mode::ackermann) && !modes.contains(Mode::lateral)) continue;
    for (bool frontend_only : {false, true})
    {
      const PlanResult result = plan_in_hall(here, there, modes, {}, frontend_only);
      EXPECT_EQ(result.status, PlanStatus::succeeded) << text(modes) << ": " << result.message;
    }
  }
}

TEST_F(PlannerTest, CountsFullTurnsOfStartAndGoalForNothing)
{
  const Pose turned = {there.x, there.y, there.theta + 4.0 * M_PI};
  EXPECT_EQ(plan_in_hall(here, turned).status, PlanStatus::succeeded);
  EXPECT_EQ(plan_in_hall(turned, here).status, PlanStatus::succeeded);
  const PlanResult parallel = plan_in_hall({2.0, 3.0, 0.3}, {6.0, 3.0, 0.3 - 2.0 * M_PI}, {Mode::parallel});
  EXPECT_EQ(parallel.status, PlanStatus::succeeded) << parallel.message;
}

TEST_F(PlannerTest, StaysWhereItIsWhenTheGoalIsThere)
{
  for (const ModeSet& modes : all_mode_sets())
  {
    const PlanResult result = plan_in_hall(here, here, modes);
    ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
    ASSERT_EQ(result.trajectory.size(), 1u);
    const TrajectoryPoint& point = result.trajectory.front();
    EXPECT_TRUE(is_bitwise_equal(point.pose(), here));
    EXPECT_EQ(point.t, 0.0);
    EXPECT_EQ(point.v, 0.0);
    EXPECT_TRUE(modes.contains(point.mode));
    EXPECT_TRUE(result.metrics.safe);
    EXPECT_EQ(result.metrics.length, 0.0);
  }
}

TEST_F(PlannerTest, ReachesGoalsNextToTheStart)
{
  for (double step : {1e-7, 1e-6, 2e-6, 1e-4, 1e-3, 0.01})
    for (double direction : {0.0, 0.7, M_PI_2, M_PI, -1.0})
      for (double turn : {0.0, 1e-7, 1e-5, 9e-5, 1.1e-4, 1e-3, -0.01})
      {
        const Pose goal = {here.x + step * std::cos(direction), here.y + step * std::sin(direction), here.theta + turn};
        const PlanResult result = plan_in_hall(here, goal, {}, {}, turn != 9e-5);
        EXPECT_EQ(result.status, PlanStatus::succeeded) << step << " m and " << turn << " rad away: " << result.message;
      }
}

TEST_F(PlannerTest, PlansOnIpoptWhatItPlansOnTheStructuredSolver)
{
  if (!has_ipopt()) GTEST_SKIP();
  const PlanRequest request = {{1.0, 1.0, 0.0}, {6.0, 4.0, 1.0}, {}};
  const World world(free_area(8.0, 6.0, 0.1), robot, options);
  const PlanResult structured = plan(world, request);
  options.optimize.solver = NlpSolver::ipopt;
  const PlanResult ipopt = plan(world, request);
  ASSERT_EQ(ipopt.status, PlanStatus::succeeded) << ipopt.message;
  EXPECT_NEAR(ipopt.metrics.arrival_time, structured.metrics.arrival_time, 1e-3);
}

TEST_F(PlannerTest, ShowsItsRoundsOnRequest)
{
  const World world(free_area(8.0, 6.0, 0.1), robot, options);
  PlanTrace trace;
  const PlanResult result = plan(world, {{1.0, 1.0, 0.0}, {6.0, 4.0, 1.0}, {}}, {}, &trace);
  ASSERT_EQ(result.status, PlanStatus::succeeded);
  ASSERT_EQ(static_cast<int>(trace.rounds.size()), result.metrics.switches + 1);
  std::size_t most = 0, all = 0;
  for (const auto& segment : trace.rounds)
  {
    most = std::max(most, segment.size());
    all += segment.size();
  }
  EXPECT_EQ(static_cast<int>(most), result.metrics.outer_iterations);
  EXPECT_EQ(trace.all_corridors().size(), all);
  EXPECT_EQ(trace.corridors().size() + trace.iterations().size(), all);
}

TEST_F(PlannerTest, ShowsTheNodesItExpandedOnRequest)
{
  PlanTrace trace;
  const World world(free_area(8.0, 6.0, 0.1), robot, options);
  const PlanResult result = plan(world, {here, there, {}}, {}, &trace);
  EXPECT_EQ(result.status, PlanStatus::succeeded);
  EXPECT_FALSE(trace.expanded.empty());
  EXPECT_LE(static_cast<int>(trace.expanded.size()), result.metrics.expansions);
}

TEST_F(PlannerTest, KnowsItsOptionsAndItsWorldTheRobot)
{
  options.planner_patience = 1.25;
  EXPECT_EQ(Planner(options).options().planner_patience, 1.25);
  Robot longer;
  longer.wheelbase = 0.9;
  const World world(free_area(8.0, 6.0, 0.1), longer, options);
  EXPECT_EQ(world.robot.wheelbase, longer.wheelbase);
  const PlanResult result = plan(world, {here, there, {}});
  ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
  EXPECT_TRUE(Referee(world.grid, options.obstacles, longer).judge(here, there, result.trajectory).accepted());
}

}  // namespace
}  // namespace fourwis
