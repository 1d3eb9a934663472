#include "search/reachability.h"

#include <gtest/gtest.h>

#include "../support/grids.h"
#include "../support/path_laws.h"
#include "fourwis_navigation/search/holonomic_distance.h"
#include "fourwis_navigation/search/hybrid_astar.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 10;
constexpr double kCell = 0.05;  ///< [m]
constexpr double kSlack = 4.0;  ///< [m]

/// The proofs; each may be wrong only by not finding out that there is no way.
struct Proofs
{
  bool by_distance, by_flood, by_places, by_holonomic_distance;
};

Proofs proofs(const Site& site, const Pose& start, const Pose& goal, double cell = kCell)
{
  const SearchProblem problem = {site.checker, start, goal};
  const GoalDistance distance(problem, kSlack);
  return {distance.reaches_start(), may_be_reachable(problem, distance, cell, Proof::quick),
          may_be_reachable(problem, distance, cell, Proof::sharp),
          HolonomicDistance(problem, cell, kSlack).reaches_start()};
}

void expect_maybe(const Site& site, const Pose& start, const Pose& goal, double cell = kCell)
{
  const Proofs found = proofs(site, start, goal, cell);
  EXPECT_TRUE(found.by_distance) << text(start) << " to " << text(goal);
  EXPECT_TRUE(found.by_flood) << text(start) << " to " << text(goal);
  EXPECT_TRUE(found.by_places) << text(start) << " to " << text(goal);
  EXPECT_TRUE(found.by_holonomic_distance) << text(start) << " to " << text(goal);
}

void expect_refused(const Site& site, const Pose& start, const Pose& goal)
{
  const Proofs found = proofs(site, start, goal);
  EXPECT_FALSE(found.by_flood) << text(start) << " to " << text(goal);
  EXPECT_FALSE(found.by_places) << text(start) << " to " << text(goal);
  EXPECT_FALSE(found.by_holonomic_distance) << text(start) << " to " << text(goal);
}

/// A path found without asking any of the proofs; without pieces where none is found soon.
Path search_for_path(const Site& site, const PlanRequest& request)
{
  SearchOptions options;
  options.max_expansions = 100;
  const auto straight = [&](const Pose& pose) { return distance(pose, request.goal); };
  return hybrid_astar({site.checker, request.start, request.goal}, options, request.modes, straight).path;
}

/// The grid in which every cell is occupied that leaves the robot room to drive the path.
OccupancyGrid tunnel_around(const Path& path, const Site& site)
{
  OccupancyGrid grid = site.grid;
  std::vector<Pose> discs;
  for (const PathPiece& piece : path.pieces)
  {
    const int steps = 1 + static_cast<int>(std::abs(piece.length) / 0.02);
    for (int k = 0; k <= steps; ++k)
      for (double offset : {site.checker.discs().offset, -site.checker.discs().offset})
        discs.push_back(relative_to(
            grid.origin, compose(advance(site.robot, piece.start, piece.mode, piece.phi, piece.length * k / steps),
                                 {offset, 0.0, 0.0})));
  }
  const double keep = site.checker.discs().radius + 1e-3;
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column)
    {
      const double left = column * grid.resolution, low = row * grid.resolution;
      const auto is_near = [&](const Pose& disc) {
        const double dx = std::max({left - disc.x, disc.x - left - grid.resolution, 0.0});
        const double dy = std::max({low - disc.y, disc.y - low - grid.resolution, 0.0});
        return dx * dx + dy * dy < keep * keep;
      };
      if (std::none_of(discs.begin(), discs.end(), is_near)) cell(grid, column, row) = 100;
    }
  return grid;
}

TEST(AProofOfUnreachability, IsNeverGivenWhereAPathExists)
{
  Random random(kSeed);
  int solved = 0;
  for (int k = 0; k < 260; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", problem " + std::to_string(k));
    const double resolutions[] = {0.05, 0.1, 0.07, 0.03};
    const Site site(clutter(random, 4.0, resolutions[k % 4], 3, random.pose(5.0)));
    const PlanRequest request = {free_pose(random, site.checker), free_pose(random, site.checker), {}};
    if (search_for_path(site, request).pieces.empty()) continue;
    ++solved;
    expect_maybe(site, request.start, request.goal);
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GE(solved, 200);
}

TEST(AProofOfUnreachability, IsNeverGivenInATunnelAsNarrowAsThePath)
{
  Robot small;
  small.length = 0.3, small.width = 0.2, small.wheelbase = 0.2, small.track_width = 0.15;
  const Robot robots[] = {Robot(), small};
  Random random(kSeed);
  int solved = 0;
  for (int k = 0; k < 60; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", problem " + std::to_string(k));
    const double resolutions[] = {0.05, 0.1, 0.07};
    const Site open(clutter(random, 5.0, resolutions[k % 3], 6, random.pose(5.0)), robots[k % 4 / 2]);
    const PlanRequest request = {free_pose(random, open.checker), free_pose(random, open.checker), {}};
    const Path path = search_for_path(open, request);
    if (path.pieces.empty()) continue;
    const Site tunnel(tunnel_around(path, open), open.robot);
    ASSERT_EQ(broken_law(path, tunnel.checker, tunnel.robot, request.modes), "");
    ++solved;
    expect_maybe(tunnel, request.start, request.goal, k % 2 ? kCell : 0.1);
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GE(solved, 30);
}

/// A room of 3 x 3 m with walls of one cell in the middle of a hall of 8 x 6 m.
struct Room : testing::TestWithParam<double>
{
  Room() : grid(free_area(8.0, 6.0, GetParam())), per_metre(static_cast<int>(std::lround(1.0 / GetParam())))
  {
    wall_in(grid, 4 * per_metre, 1 * per_metre, 3 * per_metre, 3 * per_metre);
  }

  /// Opens the left wall of the room from y = 2 m on, at least as wide.
  void open_door(double width)
  {
    const int first = 2 * per_metre, last = static_cast<int>(std::ceil((2.0 + width) / GetParam() - 1e-9));
    for (int row = first; row < last; ++row) cell(grid, 4 * per_metre - 1, row) = 0;
  }

  OccupancyGrid grid;
  int per_metre;
  const Pose outside = {2.0, 2.5, 0.3}, inside = {5.5, 2.5, -2.0};
};

TEST_P(Room, WithoutADoorIsProvenClosedFromBothSides)
{
  const Site site(grid);
  expect_refused(site, outside, inside);
  expect_refused(site, inside, outside);
}

TEST_P(Room, WithADoorNarrowerThanTheRobotIsProvenClosed)
{
  open_door(0.55);
  const Site site(grid);
  expect_refused(site, outside, inside);
  expect_refused(site, inside, outside);
}

TEST_P(Room, WithADoorWideEnoughForTheRobotAtNoHeadingIsProvenClosedByTheFloods)
{
  open_door(0.7);
  const Site site(grid);
  EXPECT_TRUE(proofs(site, outside, inside).by_distance) << "C alone would fit";
  expect_refused(site, outside, inside);
}

TEST_P(Room, WithADoorThatLacksCentimetresIsProvenClosedByThePlacesForTheDiscs)
{
  open_door(0.8);
  const Site site(grid);
  EXPECT_GT(2.0 * site.checker.discs().radius, 0.83) << "what the two discs need";
  EXPECT_TRUE(proofs(site, outside, inside).by_flood);
  EXPECT_FALSE(proofs(site, outside, inside).by_places);
  EXPECT_FALSE(proofs(site, inside, outside).by_places);
}

TEST_P(Room, WithAWideDoorIsNot)
{
  open_door(1.2);
  const Site site(grid);
  expect_maybe(site, outside, inside);
  expect_maybe(site, inside, outside);
}

INSTANTIATE_TEST_SUITE_P(Resolutions, Room, testing::Values(0.02, 0.05, 0.1));

/// A corridor in which the robot cannot turn, and in its middle, if wanted, a bay in which it can.
OccupancyGrid corridor(bool with_bay)
{
  OccupancyGrid grid = free_area(10.0, 3.0, 0.05);
  occupy_block(grid, 0, 20, 200, 40);
  if (with_bay)
    for (int row = 20; row < 50; ++row)
      for (int column = 90; column < 120; ++column) cell(grid, column, row) = 0;
  return grid;
}

TEST(AProofOfUnreachability, IsGivenWhereTheRobotHasToTurnAndCannot)
{
  const Site narrow(corridor(false)), with_bay(corridor(true));
  for (double turn : {0.05, 1.0, -1.0, -0.05})
  {
    const Pose start = {2.0, 0.5, turn * M_PI}, same = {8.0, 0.5, turn * M_PI}, other = {8.0, 0.5, (1.0 + turn) * M_PI};
    if (!narrow.checker.is_free(start)) continue;
    expect_maybe(narrow, start, same);
    expect_maybe(with_bay, start, other);
    const SearchProblem problem = {narrow.checker, start, other};
    const GoalDistance distance(problem, kSlack);
    for (Proof proof : {Proof::quick, Proof::sharp})
      EXPECT_FALSE(may_be_reachable(problem, distance, kCell, proof)) << text(other);
  }
}

TEST(AProofOfUnreachability, IsNotGivenWhenInterrupted)
{
  // Nothing is known yet when both floods have a long way to go.
  OccupancyGrid grid = free_area(30.0, 12.0, 0.1);
  occupy_block(grid, 150, 0, 1, 120);
  const Site site(grid);
  const std::atomic<bool> cancelled{true};
  const SearchProblem problem = {site.checker, {1.0, 6.0, 0.0}, {29.0, 6.0, 0.0}};
  const SearchProblem at_once = {problem.checker, problem.start, problem.goal, Interrupt(&cancelled)};
  const GoalDistance distance(problem, kSlack);
  for (Proof proof : {Proof::quick, Proof::sharp})
  {
    EXPECT_TRUE(may_be_reachable(at_once, distance, kCell, proof));
    EXPECT_FALSE(may_be_reachable(problem, distance, kCell, proof));
  }
  EXPECT_TRUE(HolonomicDistance(at_once, kCell, kSlack).reaches_start());
  EXPECT_FALSE(HolonomicDistance(problem, kCell, kSlack).reaches_start());
}

TEST(HolonomicDistance, IsNothingAtTheGoalAndAboutTheStraightLineInTheOpen)
{
  const Site site(free_area(8.0, 8.0, 0.05));
  const Pose goal = {4.0, 4.0, 0.5};
  const HolonomicDistance field({site.checker, {1.0, 1.0, 0.5}, goal}, kCell, kSlack);
  EXPECT_EQ(field(goal), 0.0);
  EXPECT_TRUE(field.reaches_start());
  Random random(kSeed);
  for (int k = 0; k < 1000; ++k)
  {
    Pose pose = free_pose(random, site.checker);
    pose.theta = goal.theta;
    if (!site.checker.is_free(pose)) continue;
    ASSERT_NEAR(field(pose), distance(pose, goal), 0.15 * distance(pose, goal) + 0.2) << text(pose);
  }
}

TEST(HolonomicDistance, ChargesForTurning)
{
  const Site site(free_area(6.0, 6.0, 0.05));
  const Pose goal = {3.0, 3.0, 0.0};
  const HolonomicDistance field({site.checker, {1.5, 1.5, 0.0}, goal}, kCell, kSlack);
  EXPECT_GT(field({3.0, 3.0, M_PI_2}), field({3.0, 3.0, M_PI_4}));
  EXPECT_GT(field({3.0, 3.0, M_PI_4}), 0.0);
  EXPECT_NEAR(field({3.0, 3.0, M_PI_2}), field({3.0, 3.0, -M_PI_2}), 2.0 * kCell);
}

}  // namespace
}  // namespace fourwis
