#include "search/reachability.h"

#include <gtest/gtest.h>

#include "../support/grids.h"
#include "../support/path_laws.h"
#include "fourwis_navigation/map/body_overlap.h"
#include "fourwis_navigation/search/hybrid_astar.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 10;
constexpr double kSlack = 4.0;  ///< [m]

constexpr double kSpacing = 0.025;  // of the lattice of the flood [m]

bool may_be_reachable(const CollisionChecker& checker, const Pose& start, const Pose& goal)
{
  const SearchProblem problem = {checker, start, goal};
  return may_be_reachable(problem, GoalDistance(problem, kSlack), kSpacing);
}

bool distance_reaches_start(const CollisionChecker& checker, const Pose& start, const Pose& goal)
{
  return GoalDistance({checker, start, goal}, kSlack).reaches_start();
}

void expect_maybe(const CollisionChecker& checker, const Pose& start, const Pose& goal)
{
  EXPECT_TRUE(distance_reaches_start(checker, start, goal)) << text(start) << " to " << text(goal);
  EXPECT_TRUE(may_be_reachable(checker, start, goal)) << text(start) << " to " << text(goal);
}

/// A path found without asking any of the proofs; without pieces where none is found soon.
Path search_for_path(const CollisionChecker& checker, const PlanRequest& request)
{
  SearchOptions options;
  options.max_expansions = 100;
  const Guide straight = {[&](const Pose& pose) { return distance(pose, request.goal); }};
  return hybrid_astar({checker, request.start, request.goal}, options, request.modes, straight).path;
}

/// Checkers that go by two discs, and by the body.
std::vector<CollisionChecker> both_checkers(const Site& site, const PlanRequest& request = {})
{
  const bool has_poses = !(request.start.x == request.goal.x && request.start.y == request.goal.y);
  return {site.checker,
          CollisionChecker(site.map, site.robot,
                           has_poses ? std::vector<Pose>{request.start, request.goal} : std::vector<Pose>())};
}

/// The grid in which every cell is occupied that leaves the robot room to drive the path.
OccupancyGrid tunnel_around(const Path& path, const Site& site, const CollisionChecker& checker)
{
  OccupancyGrid grid = site.grid;
  std::vector<bool> needed(grid.data.size(), false);
  const double keep = checker.goes_by_body() ? 0.0 : checker.discs().radius + 1e-3;
  const ConvexPolygon body = grown(body_of(site.robot), std::max(site.robot.safety_margin, 0.0005) + 1e-3);
  const auto need = [&](const CellIndex& cell) {
    needed[static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(grid.width) +
           static_cast<std::size_t>(cell.column)] = true;
  };
  const auto need_disc = [&](const Pose& centre) {
    const ConvexPolygon square = {{keep, keep}, {-keep, keep}, {-keep, -keep}, {keep, -keep}};
    const Pose disc = relative_to(grid.origin, centre);
    for (const CellIndex& cell : overlapped_cells(site.map, square, {centre.x, centre.y, grid.origin.theta}))
    {
      const double left = cell.column * grid.resolution, low = cell.row * grid.resolution;
      const double dx = std::max({left - disc.x, disc.x - left - grid.resolution, 0.0});
      const double dy = std::max({low - disc.y, disc.y - low - grid.resolution, 0.0});
      if (dx * dx + dy * dy < keep * keep) need(cell);
    }
  };
  for (const PathPiece& piece : path.pieces)
  {
    const int steps = 1 + static_cast<int>(std::abs(piece.length) / 0.005);
    for (int k = 0; k <= steps; ++k)
    {
      const Pose pose = advance(site.robot, piece.start, piece.mode, piece.phi, piece.length * k / steps);
      if (checker.goes_by_body())
        for (const CellIndex& cell : overlapped_cells(site.map, body, pose)) need(cell);
      else
        for (double offset : {checker.discs().offset, -checker.discs().offset})
          need_disc(compose(pose, {offset, 0.0, 0.0}));
    }
  }
  for (std::size_t i = 0; i < grid.data.size(); ++i)
    if (!needed[i]) grid.data[i] = 100;
  return grid;
}

TEST(AProofOfUnreachability, IsNeverGivenWhereAPathExists)
{
  Random random(kSeed);
  int solved = 0;
  for (int k = 0; k < 60; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", problem " + std::to_string(k));
    const double resolutions[] = {0.05, 0.1, 0.07, 0.03};
    const Site site(clutter(random, 4.0, resolutions[k % 4], 3, random.pose(5.0)));
    for (const CollisionChecker& checker : both_checkers(site))
    {
      const PlanRequest request = {free_pose(random, checker), free_pose(random, checker), {}};
      if (search_for_path(checker, request).pieces.empty()) continue;
      ++solved;
      expect_maybe(checker, request.start, request.goal);
    }
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GE(solved, 70);
}

/// Start and goal are as close to obstacles as the body can be, with any margin that is left there.
TEST(AProofOfUnreachability, IsNeverGivenBetweenTightPosesWithAPath)
{
  Random random(kSeed);
  int solved = 0, tight = 0;
  for (int k = 0; k < 16; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", problem " + std::to_string(k));
    const Site site(clutter(random, 3.0, 0.05, 3, random.pose(5.0)));
    const auto tight_pose = [&] {
      const ConvexPolygon body = body_of(site.robot);
      Pose free = free_pose(random, site.checker), other = compose(free, random.pose(1.0));
      for (int halving = 0; halving < 9; ++halving)
      {
        const Pose middle = {(free.x + other.x) / 2.0, (free.y + other.y) / 2.0, (free.theta + other.theta) / 2.0};
        (is_clear(site.map, body, placed(middle)) ? free : other) = middle;
      }
      return free;
    };
    const PlanRequest request = {tight_pose(), tight_pose(), {}};
    const CollisionChecker checker(site.map, site.robot, {request.start, request.goal});
    tight += static_cast<int>(checker.tight_spots().size());
    if (search_for_path(checker, request).pieces.empty()) continue;
    ++solved;
    expect_maybe(checker, request.start, request.goal);
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GE(solved, 5);
  EXPECT_GE(tight, 5);
}

TEST(AProofOfUnreachability, IsNeverGivenInATunnelAsNarrowAsThePath)
{
  Robot small;
  small.length = 0.3, small.width = 0.2, small.wheelbase = 0.2, small.track_width = 0.15;
  const Robot robots[] = {Robot(), small};
  Random random(kSeed);
  int solved = 0;
  for (int k = 0; k < 6; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", problem " + std::to_string(k));
    const double resolutions[] = {0.05, 0.1, 0.07};
    const Site open(clutter(random, 5.0, resolutions[k % 3], 6, random.pose(5.0)), robots[k % 4 / 2]);
    for (std::size_t which : {0u, 1u})
    {
      const CollisionChecker checker = both_checkers(open)[which];
      const PlanRequest request = {free_pose(random, checker), free_pose(random, checker), {}};
      const Path path = search_for_path(checker, request);
      if (path.pieces.empty()) continue;
      const Site tunnel(tunnel_around(path, open, checker), open.robot);
      const CollisionChecker in_tunnel = both_checkers(tunnel)[which];
      ASSERT_EQ(broken_law(path, in_tunnel, tunnel.robot, request.modes), "");
      ++solved;
      expect_maybe(in_tunnel, request.start, request.goal);
    }
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GE(solved, 5);
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

  void expect_refused() const
  {
    const Site site(grid);
    for (const CollisionChecker& checker : both_checkers(site))
    {
      EXPECT_FALSE(may_be_reachable(checker, outside, inside));
      EXPECT_FALSE(may_be_reachable(checker, inside, outside));
    }
  }

  OccupancyGrid grid;
  int per_metre;
  const Pose outside = {2.0, 2.5, 0.3}, inside = {5.5, 2.5, -2.0};
};

TEST_P(Room, WithoutADoorIsProvenClosedFromBothSides)
{
  expect_refused();
}

TEST_P(Room, WithADoorNarrowerThanTheRobotIsProvenClosed)
{
  open_door(0.55);
  expect_refused();
}

/// Cells that a door between 0.6 and 0.62 m can be made of.
struct RoomOfFineCells : Room
{};

TEST_P(RoomOfFineCells, WithADoorAsWideAsTheRobotIsProvenClosedThoughCAloneWouldFit)
{
  open_door(0.6);
  expect_refused();
}

TEST_P(Room, WithADoorWideEnoughForTheRobotThatGoesStraightIsNot)
{
  for (double width : {0.7, 1.2})
  {
    open_door(width);
    const Site site(grid);
    const CollisionChecker body(site.map, site.robot, std::vector<Pose>());
    expect_maybe(body, outside, inside);
    expect_maybe(body, inside, outside);
  }
}

INSTANTIATE_TEST_SUITE_P(Resolutions, Room, testing::Values(0.02, 0.05, 0.1));
INSTANTIATE_TEST_SUITE_P(Resolutions, RoomOfFineCells, testing::Values(0.02, 0.05));

/// A wall of 0.2 m with a gap: what decides is the body with its margin, less what may be missed between two checks.
TEST(AProofOfUnreachability, TellsGapsApartByCentimetres)
{
  for (const auto& [gap, closed] : {std::pair(0.56, true), {0.60, true}, {0.62, true}, {0.67, false}, {0.70, false}})
  {
    OccupancyGrid grid = free_area(6.0, 4.0, 0.01);
    occupy_block(grid, 290, 0, 20, 400);
    const int half = static_cast<int>(std::lround(gap * 50));
    for (int row = 200 - half; row < 200 - half + static_cast<int>(std::lround(gap * 100)); ++row)
      for (int column = 290; column < 310; ++column) cell(grid, column, row) = 0;
    const Site site(grid);
    const CollisionChecker body(site.map, site.robot, std::vector<Pose>());
    EXPECT_EQ(may_be_reachable(body, {1.2, 2.0, 0.7}, {4.8, 2.0, 0.0}), !closed) << gap;
  }
}

/// A corridor in which the robot cannot turn, and in its middle, if wanted, a bay in which it can.
OccupancyGrid corridor(bool with_bay)
{
  OccupancyGrid grid = free_area(10.0, 3.0, 0.05);
  occupy_block(grid, 0, 16, 200, 44);
  if (with_bay)
    for (int row = 16; row < 46; ++row)
      for (int column = 90; column < 120; ++column) cell(grid, column, row) = 0;
  return grid;
}

TEST(AProofOfUnreachability, IsGivenWhereTheRobotHasToTurnAndCannot)
{
  const Site narrow(corridor(false)), with_bay(corridor(true));
  for (double turn : {0.0, 0.01, 1.0, -1.0})
  {
    const Pose start = {2.0, 0.4, turn * M_PI}, same = {8.0, 0.4, turn * M_PI}, other = {8.0, 0.4, (1.0 + turn) * M_PI};
    for (std::size_t which : {0u, 1u})
    {
      const CollisionChecker in_narrow = both_checkers(narrow)[which], in_bay = both_checkers(with_bay)[which];
      if (!in_narrow.is_free(start)) continue;
      expect_maybe(in_narrow, start, same);
      expect_maybe(in_bay, start, other);
      EXPECT_FALSE(may_be_reachable(in_narrow, start, other)) << text(other);
    }
  }
}

/// A goal beyond half the spacing of the last point of a coarse lattice that lies on the grid, as on very large maps.
TEST(AProofOfUnreachability, IsNotGivenBesideTheBorderHoweverCoarseTheLatticeIs)
{
  const Site site(free_area(4.9, 4.9, 0.1));
  const CollisionChecker body(site.map, site.robot, std::vector<Pose>());
  const SearchProblem problem = {body, {1.0, 2.0, M_PI_2}, {4.55, 2.0, M_PI_2}};
  for (double spacing : {0.3, 1.0, 1.7, 4.0})
    EXPECT_TRUE(may_be_reachable(problem, GoalDistance(problem, kSlack), spacing)) << spacing;
}

TEST(AProofOfUnreachability, IsNotGivenWhenInterrupted)
{
  // Nothing is known yet when the search for a chain has a long way to go.
  OccupancyGrid grid = free_area(30.0, 12.0, 0.1);
  occupy_block(grid, 150, 0, 1, 120);
  const Site site(grid);
  const std::atomic<bool> cancelled{true};
  const SearchProblem problem = {site.checker, {1.0, 6.0, 0.0}, {29.0, 6.0, 0.0}};
  const SearchProblem at_once = {problem.checker, problem.start, problem.goal, Interrupt(&cancelled)};
  const GoalDistance distance(problem, kSlack);
  EXPECT_TRUE(may_be_reachable(at_once, distance, kSpacing));
  EXPECT_FALSE(may_be_reachable(problem, distance, kSpacing));
}

}  // namespace
}  // namespace fourwis
