#include "search/mode_curves.h"

#include <gtest/gtest.h>

#include <limits>

#include "../support/drive.h"
#include "../support/grids.h"
#include "../support/path_laws.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 8;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAccuracy = 1e-9;

struct Curves : testing::Test
{
  /// A connection asked for: from where, to where, beginning how.
  struct Problem
  {
    Pose from, goal;
    ModeSet modes;
    ModeCurves::Situation situation;
    double budget;
  };

  /// Visits problems of all sizes, mode sets and situations with their candidates, which are placed.
  template <typename Visit>
  void for_problems(Visit visit)
  {
    Random random(kSeed);
    PathPiece before;
    for (int k = 0; k < 1500; ++k)
    {
      const double size = k % 3 == 0 ? 0.3 : k % 3 == 1 ? 2.0 : 15.0;
      Problem problem{random.pose(5.0),
                      {},
                      all_mode_sets()[static_cast<std::size_t>(k) % 7],
                      {random.mode(), nullptr, k % 3 == 1},
                      k % 2 == 0 ? kInfinity : random.between(0.0, 30.0)};
      problem.goal = compose(problem.from, random.pose(size));
      if (k % 5 == 0) problem.goal.theta = problem.from.theta;
      const Mode mode = problem.situation.mode;
      before = {mode, {}, random.steering(robot, mode), random.between(-1.0, 1.0)};
      if (k % 3 == 0) problem.situation.previous = &before;
      const ModeCurves curves(robot, options, cost, problem.modes);
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", " + text(problem.modes) + " in " + to_string(mode) + " from " +
                   text(problem.from) + " to " + text(problem.goal));
      visit(problem, curves, candidates(curves, problem));
      if (HasFatalFailure()) return;
    }
  }

  static std::vector<ModeCurve> candidates(const ModeCurves& curves, const Problem& problem)
  {
    std::vector<ModeCurve> found;
    curves.candidates(problem.from, problem.situation, problem.goal, problem.budget, found);
    for (ModeCurve& curve : found) curves.place(problem.from, curve);
    return found;
  }

  static std::vector<PathPiece> pieces_of(const ModeCurve& curve)
  {
    return {curve.pieces.begin(), curve.pieces.begin() + curve.count};
  }

  const Robot robot;
  const SearchOptions options;
  const MotionCost cost{robot, options};
  const ModeSet only_parallel = {Mode::parallel}, all_modes;
};

TEST_F(Curves, AllEndAtTheGoal)
{
  for_problems([this](const Problem& problem, const ModeCurves&, const std::vector<ModeCurve>& found) {
    for (const ModeCurve& curve : found)
    {
      Pose pose = problem.from;
      for (const PathPiece& piece : pieces_of(curve))
        pose = drive_numerically(robot, pose, piece.mode, piece.phi, piece.length);
      ASSERT_LE(distance(pose, problem.goal), kAccuracy);
      ASSERT_LE(heading_gap(pose.theta, problem.goal.theta), kAccuracy);
    }
  });
}

TEST_F(Curves, AreChainsOfPieces)
{
  for_problems([](const Problem& problem, const ModeCurves& curves, const std::vector<ModeCurve>& found) {
    for (const ModeCurve& curve : found)
    {
      ASSERT_GE(curve.count, 1);
      ASSERT_LE(curve.count, ModeCurve::kMaxPieces);
      Pose pose = problem.from;
      for (const PathPiece& piece : pieces_of(curve))
      {
        ASSERT_TRUE(is_bitwise_equal(piece.start, pose));
        pose = curves.end_of(piece);
      }
    }
  });
}

TEST_F(Curves, UseAllowedModesAndSteeringAnglesOnly)
{
  for_problems([this](const Problem& problem, const ModeCurves&, const std::vector<ModeCurve>& found) {
    for (const ModeCurve& curve : found)
      for (const PathPiece& piece : pieces_of(curve))
      {
        ASSERT_TRUE(problem.modes.contains(piece.mode)) << text(piece);
        ASSERT_LE(std::abs(piece.phi), piece.mode == Mode::parallel ? M_PI_2 : robot.max_steering_angle);
        ASSERT_NE(piece.length, 0.0);
      }
  });
}

TEST_F(Curves, CostWhatTheirPiecesAndSwitchesCost)
{
  for_problems([this](const Problem& problem, const ModeCurves&, const std::vector<ModeCurve>& found) {
    for (const ModeCurve& curve : found)
    {
      double expected = 0.0;
      const PathPiece* previous = problem.situation.previous;
      Mode mode = problem.situation.mode;
      for (int i = 0; i < curve.count; ++i)
      {
        const PathPiece& piece = curve.pieces[static_cast<std::size_t>(i)];
        const bool switches = piece.mode != mode;
        expected += (switches ? cost.mode_switch(i == 0 && problem.situation.at_start) : 0.0) +
                    cost.piece(piece, switches ? nullptr : previous);
        mode = piece.mode;
        previous = &piece;
      }
      ASSERT_NEAR(curve.cost, expected, kAccuracy);
    }
  });
}

TEST_F(Curves, ComeCheapestFirstAndWithinTheBudget)
{
  for_problems([](const Problem& problem, const ModeCurves&, const std::vector<ModeCurve>& found) {
    double last = 0.0;
    for (const ModeCurve& curve : found)
    {
      ASSERT_LT(curve.cost, problem.budget);
      ASSERT_GE(curve.cost, last);
      last = curve.cost;
    }
  });
}

TEST_F(Curves, WithinABudgetAreTheCheaperOnesOfAll)
{
  for_problems([](const Problem& problem, const ModeCurves& curves, const std::vector<ModeCurve>& found) {
    Problem unlimited = problem;
    unlimited.budget = kInfinity;
    std::size_t cheaper = 0;
    for (const ModeCurve& curve : candidates(curves, unlimited)) cheaper += curve.cost < problem.budget;
    ASSERT_EQ(found.size(), cheaper);
  });
}

TEST_F(Curves, ExistUnlessOnlyParallelMotionIsLeftToTurnTheRobot)
{
  for_problems([](const Problem& problem, const ModeCurves&, const std::vector<ModeCurve>& found) {
    if (problem.budget < kInfinity) return;
    const bool turns = problem.modes.contains(Mode::ackermann) || problem.modes.contains(Mode::lateral);
    ASSERT_EQ(found.empty(), !turns && heading_gap(problem.from.theta, problem.goal.theta) > 1e-3);
  });
}

TEST_F(Curves, OfParallelMotionAloneAreOneStraightLine)
{
  const ModeCurves curves(robot, options, cost, only_parallel);
  Random random(kSeed);
  for (int k = 0; k < 200; ++k)
  {
    const Pose from = random.pose(5.0), goal = {from.x + random.between(-3.0, 3.0), from.y + 1.0, from.theta};
    const std::vector<ModeCurve> found = candidates(curves, {from, goal, {}, {Mode::parallel}, kInfinity});
    ASSERT_EQ(found.size(), 1u) << text(from) << " to " << text(goal);
    ASSERT_EQ(found[0].count, 1);
    ASSERT_NEAR(std::abs(found[0].pieces[0].length), distance(from, goal), kAccuracy);
  }
}

TEST_F(Curves, ToWhereTheRobotIsAreNotEmpty)
{
  for (const ModeSet& modes : all_mode_sets())
  {
    const ModeCurves curves(robot, options, cost, modes);
    for (Mode mode : kPlannedModes)
      for (const ModeCurve& curve : candidates(curves, {{1, 2, 3}, {1, 2, 3}, {}, {mode}, kInfinity}))
        EXPECT_GT(cost_of(pieces_of(curve), mode, cost), 0.1) << "a curve of hardly any length";
  }
}

/// A robot whose left side is its front.
Robot turned(const Robot& robot)
{
  Robot other = robot;
  std::swap(other.wheelbase, other.track_width);
  return other;
}

TEST_F(Curves, OfLateralMotionAreThoseOfAckermannMotionOfTheRobotTurnedByARightAngle)
{
  SearchOptions fair;
  fair.lateral_reverse_penalty = fair.reverse_penalty;
  fair.step_time = 0.5;  // penalties are per primitive
  const Robot sideways = turned(robot);
  const MotionCost lateral_cost(robot, fair), ackermann_cost(sideways, fair);
  const ModeSet only_lateral = {Mode::lateral}, only_ackermann = {Mode::ackermann};
  const ModeCurves lateral(robot, fair, lateral_cost, only_lateral);
  const ModeCurves ackermann(sideways, fair, ackermann_cost, only_ackermann);
  Random random(kSeed);
  for (int k = 0; k < 300; ++k)
  {
    const Pose from = random.pose(3.0), goal = random.pose(3.0), turn = {0.0, 0.0, M_PI_2};
    const auto a = candidates(lateral, {from, goal, {}, {Mode::lateral}, kInfinity});
    const auto b = candidates(ackermann, {compose(from, turn), compose(goal, turn), {}, {Mode::ackermann}, kInfinity});
    ASSERT_EQ(a.size(), b.size()) << text(from) << " to " << text(goal);
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      ASSERT_NEAR(a[i].cost, b[i].cost, 1e-6) << text(from) << " to " << text(goal);
      for (const PathPiece& piece : pieces_of(a[i])) ASSERT_EQ(piece.mode, Mode::lateral);
    }
  }
}

TEST_F(Curves, AreNeverShorterThanTheLengthTheHeuristicGoesBy)
{
  for_problems([this](const Problem& problem, const ModeCurves& curves, const std::vector<ModeCurve>& found) {
    const double bound = curves.length_with_switches(problem.from, problem.situation.mode, problem.goal);
    ASSERT_GE(bound, distance(problem.from, problem.goal) - kAccuracy);
    if (found.empty()) return;
    for (const ModeCurve& curve : found)
    {
      double length = 0.0;
      Mode mode = problem.situation.mode;
      for (const PathPiece& piece : pieces_of(curve))
      {
        length += std::abs(piece.length) + (piece.mode != mode ? cost.mode_switch(false) : 0.0);
        mode = piece.mode;
      }
      ASSERT_LE(bound, length + kAccuracy) << text(Path{pieces_of(curve), {}, curve.cost});
    }
  });
}

TEST_F(Curves, HaveNoLengthWhereNoModeGetsThere)
{
  const ModeCurves curves(robot, options, cost, only_parallel);
  EXPECT_EQ(curves.length_with_switches({}, Mode::parallel, {1.0, 0.0, 0.5}), kInfinity);
  EXPECT_NEAR(curves.length_with_switches({}, Mode::parallel, {3.0, 4.0, 0.0}), 5.0, kAccuracy);
}

TEST_F(Curves, AreFreeWhenEachOfTheirPiecesIs)
{
  OccupancyGrid grid = free_area(10.0, 10.0, 0.1);
  occupy_block(grid, 70, 0, 1, 100);
  const Site site(grid);
  ModeCurve curve;
  curve.append(Mode::ackermann, 0.0, 1.0);
  curve.append(Mode::parallel, M_PI_2, 1.0);
  const ModeCurves curves(robot, options, cost, all_modes);
  curves.place({2.0, 5.0, 0.0}, curve);
  EXPECT_TRUE(is_free(site.checker, curve));
  curves.place({6.0, 5.0, 0.0}, curve);
  EXPECT_FALSE(is_free(site.checker, curve));
  curves.place({6.0, 5.0, M_PI_2}, curve);
  EXPECT_TRUE(is_free(site.checker, curve));
  curves.place({6.0, 5.0, -M_PI_2}, curve);
  EXPECT_FALSE(is_free(site.checker, curve)) << "the last piece leads into the wall";
}

}  // namespace
}  // namespace fourwis
