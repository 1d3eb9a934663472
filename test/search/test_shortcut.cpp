#include "search/shortcut.h"

#include <gtest/gtest.h>

#include "../support/grids.h"
#include "../support/path_laws.h"
#include "fourwis_navigation/search/hybrid_astar.h"
#include "search/goal_distance.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 11;
constexpr double kAccuracy = 1e-6;

/// A robot on a map, with what shortcuts are made from.
struct Shortcutter
{
  Shortcutter(const OccupancyGrid& grid, const ModeSet& the_modes)
    : site(grid),
      modes(the_modes),
      cost(site.robot, options),
      curves(site.robot, options, cost, modes)
  {}

  Path operator()(const Path& path, const Interrupt& interrupt = {}) const
  {
    return shortcut(site.checker, curves, path, interrupt);
  }
  double cost_of(const Path& path) const { return fourwis::cost_of(path.pieces, modes.first(), cost); }

  const Site site;
  const ModeSet modes;
  const SearchOptions options;
  const MotionCost cost;
  const ModeCurves curves;
};

/// A detour driven piece by piece in the middle of an empty hall.
Path detour(const Shortcutter& shortcutter, const Pose& start)
{
  struct Step
  {
    Mode mode;
    double phi, length;
  };
  constexpr Step steps[] = {{Mode::ackermann, 0.5, 1.0},  {Mode::ackermann, -0.5, 1.5}, {Mode::lateral, 0.2, -0.7},
                            {Mode::ackermann, 0.0, -1.0}, {Mode::parallel, 1.0, 1.0},   {Mode::lateral, -0.4, 1.0},
                            {Mode::ackermann, 0.3, 2.0},  {Mode::parallel, -0.5, -0.4}, {Mode::ackermann, -0.2, 1.3}};
  Path path;
  path.goal = start;
  for (const Step& step : steps)
  {
    path.pieces.push_back({step.mode, path.goal, step.phi, step.length});
    path.goal = shortcutter.curves.end_of(path.pieces.back());
  }
  path.cost = shortcutter.cost_of(path);
  return path;
}

struct Shortcut : testing::Test
{
  /// Visits paths found by the search alone, among clutter, in all sets of modes that can turn.
  template <typename Visit>
  void for_paths(Visit visit)
  {
    Random random(kSeed);
    int found = 0;
    for (int k = 0; k < 90; ++k)
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", problem " + std::to_string(k));
      constexpr std::size_t turning[] = {0, 1, 2, 4, 5, 6};
      const ModeSet modes = all_mode_sets()[turning[k % 6]];
      const Shortcutter shortcutter(clutter(random, 7.0, k % 2 ? 0.05 : 0.1, 10, random.pose(5.0)), modes);
      const Site& site = shortcutter.site;
      const PlanRequest request = {free_pose(random, site.checker), free_pose(random, site.checker), modes};
      SearchOptions options;
      options.max_expansions = 600;
      const SearchProblem problem = {site.checker, request.start, request.goal};
      const GoalDistance distance(problem, 4.0);
      const Guide around = {[&](const Pose& pose) { return distance(pose.x, pose.y); }};
      const Path path = hybrid_astar(problem, options, modes, around).path;
      if (path.pieces.empty()) continue;
      ++found;
      visit(shortcutter, request, path);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(found, 40);
  }
};

TEST_F(Shortcut, NeverCostsMore)
{
  int improved = 0;
  for_paths([&](const Shortcutter& shorten, const PlanRequest&, const Path& path) {
    const Path shortened = shorten(path);
    ASSERT_LE(shortened.cost, path.cost + kAccuracy) << text(path) << text(shortened);
    ASSERT_LE(shorten.cost_of(shortened), shorten.cost_of(path) + kAccuracy) << text(path) << text(shortened);
    improved += shortened.cost < path.cost - 1e-3;
  });
  EXPECT_GT(improved, 10);
}

TEST_F(Shortcut, CostsWhatItsPiecesCost)
{
  for_paths([](const Shortcutter& shorten, const PlanRequest&, const Path& path) {
    const Path shortened = shorten(path);
    ASSERT_NEAR(shortened.cost, shorten.cost_of(shortened), kAccuracy) << text(path) << text(shortened);
  });
}

TEST_F(Shortcut, LeadsFromTheSameStartToTheSameGoalWithoutCollisionsGapsAndJumps)
{
  for_paths([](const Shortcutter& shorten, const PlanRequest& request, const Path& path) {
    const Site& site = shorten.site;
    const Path shortened = shorten(path);
    ASSERT_EQ(broken_law(shortened, site.checker, site.robot, request.modes, request.start, request.goal), "");
  });
}

TEST_F(Shortcut, OverAndOverStaysValid)
{
  for_paths([](const Shortcutter& shorten, const PlanRequest& request, Path path) {
    const Site& site = shorten.site;
    for (int pass = 0; pass < 6; ++pass) path = shorten(path);
    ASSERT_EQ(broken_law(path, site.checker, site.robot, request.modes, request.start, request.goal), "");
  });
}

TEST_F(Shortcut, IsTheSameEveryTime)
{
  for_paths([](const Shortcutter& shorten, const PlanRequest&, const Path& path) {
    ASSERT_TRUE(is_bitwise_equal(shorten(path), shorten(path)));
  });
}

TEST_F(Shortcut, CutsADetourInTheOpenShort)
{
  const Shortcutter shorten(free_area(16.0, 16.0, 0.1), {});
  const Path path = detour(shorten, {8.0, 8.0, 0.4}), shortened = shorten(path);
  EXPECT_LT(shortened.cost, 0.7 * path.cost);
  EXPECT_LT(shortened.length(), path.length());
  EXPECT_EQ(broken_law(shortened, shorten.site.checker, shorten.site.robot, {}, path.pieces.front().start, path.goal),
            "");
}

TEST_F(Shortcut, MeetsAFarGoalAlsoWhenHeadingsOnTheWayDifferByNextToNothing)
{
  OccupancyGrid grid = free_area(28.0, 50.0, 0.1);
  occupy_block(grid, 0, 40, 240, 460);
  const Shortcutter shorten(grid, {});
  const double kappa = max_curvature(shorten.site.robot, Mode::ackermann), lock = M_PI / 6.0;
  for (double turn : {1e-7, 1e-6, 1e-5, 8e-5, 1.1e-4, 1e-3})
  {
    // To the left and back again but for a very small turn, along a wall, around its corner, and on for long.
    Path path;
    path.goal = {2.0, 2.0, 0.0};
    for (const PathPiece& piece :
         {PathPiece{Mode::ackermann, {}, lock, 0.5}, PathPiece{Mode::ackermann, {}, -lock, 0.5 - turn / kappa},
          PathPiece{Mode::ackermann, {}, 0.0, 22.5}, PathPiece{Mode::ackermann, {}, lock, M_PI_2 / kappa},
          PathPiece{Mode::ackermann, {}, 0.0, 44.0}})
    {
      path.pieces.push_back(piece);
      path.pieces.back().start = path.goal;
      path.goal = shorten.curves.end_of(path.pieces.back());
    }
    path.cost = shorten.cost_of(path);
    ASSERT_EQ(broken_law(path, shorten.site.checker, shorten.site.robot, {}), "");
    const Path shortened = shorten(path);
    EXPECT_LT(shortened.cost, path.cost) << turn;
    EXPECT_LE(distance(shortened.goal, path.goal), 1e-4) << turn;
    EXPECT_LE(heading_gap(shortened.goal.theta, path.goal.theta), 2e-4) << turn;
  }
}

TEST_F(Shortcut, LeavesAStraightLineAlone)
{
  const Shortcutter shorten(free_area(16.0, 16.0, 0.1), {});
  const Pose start = {3.0, 8.0, 0.0}, middle = {6.0, 8.0, 0.0}, goal = {10.0, 8.0, 0.0};
  Path path;
  path.pieces = {{Mode::ackermann, start, 0.0, 3.0}, {Mode::ackermann, middle, 0.0, 4.0}};
  path.goal = goal;
  path.cost = 7.0;
  const Path shortened = shorten(path);
  EXPECT_NEAR(shortened.cost, 7.0, kAccuracy);
  EXPECT_NEAR(shortened.length(), 7.0, kAccuracy);
}

TEST_F(Shortcut, LeavesShortPathsAlone)
{
  const Shortcutter shorten(free_area(16.0, 16.0, 0.1), {});
  EXPECT_TRUE(is_bitwise_equal(shorten(Path()), Path()));
  Path path;
  path.pieces = {{Mode::lateral, {3.0, 8.0, 0.0}, 0.1, 3.0}};
  path.goal = shorten.curves.end_of(path.pieces[0]);
  path.cost = shorten.cost_of(path);
  EXPECT_LE(shorten(path).cost, path.cost + kAccuracy);
}

TEST_F(Shortcut, IsAValidPathAlsoWhenInterrupted)
{
  const std::atomic<bool> cancelled{true};
  for_paths([&](const Shortcutter& shorten, const PlanRequest& request, const Path& path) {
    const Site& site = shorten.site;
    const Path shortened = shorten(path, Interrupt(&cancelled));
    ASSERT_LE(shortened.cost, path.cost + kAccuracy);
    ASSERT_EQ(broken_law(shortened, site.checker, site.robot, request.modes, request.start, request.goal), "");
  });
}

}  // namespace
}  // namespace fourwis
