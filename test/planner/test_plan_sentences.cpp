// What the planner says where it has no plan: each kind its own sentence, with numbers that are true.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "../support/sentences.h"
#include "fourwis_navigation/planner/planner.h"
#include "hall.h"
#include "planner/plan_sentences.h"

namespace fourwis
{
namespace
{

/// How far apart poses are at which a free one is looked for, in sizes of the robot [m].
constexpr double kSearchStep = 0.1;

struct Sentences : testing::Test
{
  Sentences() { options.planner_patience = 60.0; }

  PlanResult plan(const OccupancyGrid& grid, const Pose& start, const Pose& goal, const ModeSet& modes = {}) const
  {
    return Planner(options).plan(World(grid, robot, options), {start, goal, modes});
  }

  /// The number before some words, NaN where they are not said.
  static double number_before(const std::string& text, const std::string& words)
  {
    const std::size_t at = text.find(words);
    if (at == std::string::npos || at == 0) return std::nan("");
    const std::size_t begin = text.find_last_of(' ', at - 1);
    return std::atof(text.substr(begin + 1, at - begin - 1).c_str());
  }

  /// At least as far as it is, and at most the next pose that is looked at.
  static void expect_nearest(const PlanResult& result, double distance)
  {
    const double said = number_before(result.message, " m away");
    EXPECT_GE(said, distance - 0.006) << result.message;
    EXPECT_LE(said, distance + kSearchStep + 0.006) << result.message;
    EXPECT_TRUE(says(result.message, "the nearest free pose is "));
  }

  Robot robot;
  PlannerOptions options;
  const Pose here = {2.0, 3.0, 0.3}, there = {6.0, 3.0, -0.5};
  const OccupancyGrid empty = free_area(20.0, 10.0, 0.1);
};

TEST_F(Sentences, OffTheMap)
{
  const PlanResult goal = plan(empty, {10.0, 5.0, 0.0}, {90.0, 5.0, 0.0});
  EXPECT_EQ(goal.status, PlanStatus::goal_in_collision);
  EXPECT_TRUE(says(goal.message, "the goal (90.000, 5.000, 0.000) is off the map, which is 20.00 x 10.00 m large; "));
  expect_nearest(goal, 70.0 + robot.width / 2.0);
  const PlanResult start = plan(empty, {0.3, 5.0, 0.0}, {10.0, 5.0, 0.0});
  EXPECT_EQ(start.status, PlanStatus::start_in_collision);
  EXPECT_TRUE(says(start.message, "the start (0.300, 5.000, 0.000) is off the map"));
  expect_nearest(start, robot.width / 2.0 - 0.3);
}

TEST_F(Sentences, OffAMapThatLiesElsewhere)
{
  OccupancyGrid elsewhere = empty;
  elsewhere.origin = {100.0, 50.0, M_PI_2};
  const PlanResult goal = plan(elsewhere, compose(elsewhere.origin, {10.0, 5.0, 0.0}), {100.0, 20.0, M_PI_2});
  EXPECT_TRUE(says(goal.message, "the goal (100.000, 20.000, 1.571) is off the map, which is 20.00 x 10.00 m large; "));
  // Thirty metres off, half a metre from two sides.
  EXPECT_NEAR(number_before(goal.message, " m away"), std::hypot(30.4, 0.4), 0.3) << goal.message;
}

TEST_F(Sentences, UnseenCells)
{
  OccupancyGrid grid = empty;
  for (int row = 0; row < 100; ++row)
    for (int column = 100; column < 200; ++column) cell(grid, column, row) = -1;
  const PlanResult goal = plan(grid, here, {12.0, 5.0, 0.0});
  EXPECT_EQ(goal.status, PlanStatus::goal_in_collision);
  EXPECT_TRUE(says(goal.message, "the goal (12.000, 5.000, 0.000) lies on cells that no sensor has seen; "));
  expect_nearest(goal, 2.0 + robot.width / 2.0);
}

TEST_F(Sentences, AWallUnderTheBodyIsNoUnseenGround)
{
  OccupancyGrid grid = empty;
  for (int row = 0; row < 100; ++row)
    for (int column = 100; column < 200; ++column) cell(grid, column, row) = -1;
  occupy_block(grid, 118, 48, 4, 4);
  const PlanResult goal = plan(grid, here, {12.0, 5.0, 0.0});
  EXPECT_FALSE(says(goal.message, "no sensor has seen")) << goal.message;
  EXPECT_TRUE(says(goal.message, "is in collision: it lies in an obstacle; ")) << goal.message;
}

TEST_F(Sentences, AnOverlapHasItsDepth)
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.01);
  occupy_block(grid, 0, 0, 800, 100);
  for (const auto& [depth, said] : {std::pair(0.001, "0.001"), {0.031, "0.031"}, {0.04, "0.040"}, {0.123, "0.123"}})
  {
    const Pose pose = {4.0, 1.0 + robot.width / 2.0 - depth, 0.0};
    const PlanResult goal = plan(grid, here, pose);
    EXPECT_EQ(goal.status, PlanStatus::goal_in_collision);
    EXPECT_TRUE(says(goal.message, std::string("is in collision: the body overlaps an obstacle by ") + said + " m; "));
    expect_nearest(goal, depth);
  }
  const PlanResult start = plan(grid, {4.0, 1.0 + robot.width / 2.0 - 0.04, 0.0}, there);
  EXPECT_EQ(start.status, PlanStatus::start_in_collision);
  EXPECT_TRUE(says(start.message,
                   "the start (4.000, 1.270, 0.000) is in collision: the body overlaps an obstacle by 0.040 m; "));
}

TEST_F(Sentences, ARoomThatIsTooSmallForTheBody)
{
  const OccupancyGrid corridor = free_area(30.0, 0.6, 0.1);
  const PlanResult result = plan(corridor, {5.0, 0.3, 0.0}, {20.0, 0.3, 0.0});
  EXPECT_EQ(result.status, PlanStatus::start_in_collision);
  EXPECT_TRUE(says(result.message, "a body of 1.00 x 0.62 m fits nowhere within 10.0 m"));
}

TEST_F(Sentences, AWayThatIsTooNarrowForTheBodyWithItsMargin)
{
  for (int gap : {40, 63})
  {
    const PlanResult result = plan(gap_hall(gap), {1.2, 2.0, 0.0}, {4.8, 2.0, 0.0});
    EXPECT_EQ(result.status, PlanStatus::goal_unreachable) << gap << " cm: " << result.message;
    EXPECT_TRUE(
        says(result.message,
             "the robot cannot get from (1.20, 2.00, 0.00) to (4.80, 2.00, 0.00): no way is wide enough for a body of "
             "1.00 x 0.62 m with a margin of 0.020 m on each side"));
  }
}

TEST_F(Sentences, AGoalThatHasToBeTurnedToInParallelMotion)
{
  const PlanResult result = plan(empty, here, there, {Mode::parallel});
  EXPECT_EQ(result.status, PlanStatus::goal_unreachable);
  EXPECT_TRUE(says(result.message, "parallel motion alone does not turn"));
}

TEST_F(Sentences, ModesThatTheWheelsCannotDo)
{
  robot.wheel_max_angle = 1.4;
  const PlanResult result = plan(empty, here, there, {Mode::lateral});
  EXPECT_EQ(result.status, PlanStatus::invalid_input);
  EXPECT_EQ(result.message, "no motion mode that the wheels can do is allowed");
}

TEST_F(Sentences, APlanSaysWhichCandidateItIs)
{
  const PlanResult result = plan(empty, here, there);
  ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
  EXPECT_FALSE(result.candidate.empty());
  EXPECT_EQ(result.fallback_parts, 0);
  EXPECT_EQ(result.overlap, 0.0);
  EXPECT_FALSE(result.degraded);
}

TEST_F(Sentences, APlanThatTheDeadlineCutShortSaysSo)
{
  // Where it is cut short depends on the machine: what is said must be true wherever it is.
  const World world(maze(), robot, options);
  for (double patience = 0.002; patience < 1.0; patience *= 1.3)
  {
    const PlanResult result =
        Planner(options).plan(world, {{0.8, 0.8, 0.0}, {11.0, 11.2, M_PI_2}, {}}, Interrupt().or_after(patience));
    if (result.status != PlanStatus::succeeded) continue;
    EXPECT_EQ(static_cast<bool>(says(result.message, "planner_patience was over before it was optimised")),
              result.degraded);
  }
}

TEST(Remarks, SayWhatIsNotAsItShouldBe)
{
  PlanResult result;
  EXPECT_EQ(remarks(result, ""), "");
  result.fallback_parts = 1;
  EXPECT_EQ(remarks(result, "no corridor"), "; 1 of its parts stops wherever the steering changes (no corridor)");
  result.fallback_parts = 3;
  result.degraded = true;
  EXPECT_EQ(remarks(result, "no corridor"),
            "; 3 of its parts stop wherever the steering changes (no corridor); planner_patience was over before it "
            "was optimised");
}

}  // namespace
}  // namespace fourwis
