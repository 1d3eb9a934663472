#include "fourwis_navigation/search/search.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "../support/grids.h"
#include "../support/path_laws.h"
#include "../support/sentences.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 12;

struct FrontEnd : testing::Test
{
  FrontEnd() { options.max_expansions = 2500; }

  SearchResult find(const Site& site, const PlanRequest& request, const Interrupt& interrupt = {},
                    std::vector<Pose>* expanded = nullptr) const
  {
    return find(site.checker, request, Effort::thorough, interrupt, expanded);
  }

  SearchResult find(const CollisionChecker& checker, const PlanRequest& request, Effort effort,
                    const Interrupt& interrupt = {}, std::vector<Pose>* expanded = nullptr) const
  {
    return Search({checker, request.start, request.goal, interrupt}).find(options, request.modes, effort, expanded);
  }

  /// Visits requests among clutter, for all seven sets of modes.
  template <typename Visit>
  void for_requests(int count, Visit visit) const
  {
    Random random(kSeed);
    for (int k = 0; k < count; ++k)
    {
      const ModeSet modes = all_mode_sets()[static_cast<std::size_t>(k) % 7];
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", request " + std::to_string(k) + ", " + text(modes));
      const Site site(clutter(random, 7.0, k % 2 ? 0.05 : 0.1, 8, random.pose(5.0)));
      PlanRequest request = {free_pose(random, site.checker), free_pose(random, site.checker), modes};
      if (!modes.contains(Mode::ackermann) && !modes.contains(Mode::lateral))
      {
        do request.goal = free_pose(random, site.checker);
        while (!site.checker.is_free(Pose{request.goal.x, request.goal.y, request.start.theta}));
        request.goal.theta = request.start.theta;
      }
      visit(site, request);
      if (HasFatalFailure()) return;
    }
  }

  void expect_valid(const Site& site, const PlanRequest& request, const Path& path) const
  {
    EXPECT_EQ(broken_law(path, site.checker, site.robot, request.modes, request.start, request.goal), "") << text(path);
  }

  SearchOptions options;
};

TEST_F(FrontEnd, FindsPathsThatKeepTheirPromisesInEverySetOfModes)
{
  int found = 0;
  for_requests(42, [&](const Site& site, const PlanRequest& request) {
    const SearchResult result = find(site, request);
    if (result.status != PlanStatus::succeeded) return;
    ++found;
    expect_valid(site, request, result.path);
  });
  EXPECT_GT(found, 24);
}

TEST_F(FrontEnd, ReportsWhatThePathCosts)
{
  for_requests(42, [&](const Site& site, const PlanRequest& request) {
    const SearchResult result = find(site, request);
    if (result.status != PlanStatus::succeeded) return;
    const double cost = cost_of(result.path.pieces, request.modes.first(), MotionCost(site.robot, options));
    ASSERT_NEAR(result.path.cost, cost, 1e-6) << text(result.path);
  });
}

TEST_F(FrontEnd, FindsAPathInTheOpenAtOnceUnlessParallelMotionHasToTurn)
{
  const Site site(free_area(14.0, 14.0, 0.1));
  Random random(kSeed);
  for (const ModeSet& modes : all_mode_sets())
    for (int k = 0; k < 5; ++k)
    {
      const Pose offset = {random.between(-2.0, 2.0), random.between(-2.0, 2.0), 0.0};
      PlanRequest request = {{7.0, 7.0, random.angle()}, {}, modes};
      request.goal = compose(request.start, offset);
      if (modes.contains(Mode::ackermann) || modes.contains(Mode::lateral)) request.goal.theta = random.angle();
      const SearchResult result = find(site.checker, request, Effort::quick);
      ASSERT_EQ(result.status, PlanStatus::succeeded) << text(modes) << " to " << text(request.goal);
      EXPECT_LE(result.expansions, 2) << text(modes) << " to " << text(request.goal);
      expect_valid(site, request, result.path);
    }
}

TEST_F(FrontEnd, GivesTheSameAnswerBitForBit)
{
  for_requests(28, [&](const Site& site, const PlanRequest& request) {
    std::vector<Pose> first_expanded, second_expanded;
    const SearchResult first = find(site, request, {}, &first_expanded);
    const Site again(site.grid);
    const SearchResult second = find(again, request, {}, &second_expanded);
    ASSERT_EQ(first.status, second.status);
    ASSERT_EQ(first.expansions, second.expansions);
    ASSERT_TRUE(is_bitwise_equal(first.path, second.path));
    ASSERT_EQ(first_expanded.size(), second_expanded.size());
    for (std::size_t i = 0; i < first_expanded.size(); ++i)
      ASSERT_TRUE(is_bitwise_equal(first_expanded[i], second_expanded[i]));
  });
}

TEST_F(FrontEnd, ShowsEveryPoseItExpands)
{
  options.max_expansions = 500;
  int most = 0;
  for_requests(28, [&](const Site& site, const PlanRequest& request) {
    std::vector<Pose> expanded = {{1.0, 2.0, 3.0}};
    const SearchResult result = find(site, request, {}, &expanded);
    ASSERT_EQ(static_cast<int>(expanded.size()), 1 + result.expansions) << "appended, one for each expansion";
    EXPECT_EQ(expanded[0].x, 1.0);
    for (std::size_t i = 1; i < expanded.size(); ++i) ASSERT_TRUE(site.checker.is_free(expanded[i]));
    most = std::max(most, result.expansions);
  });
  EXPECT_GT(most, 10);
}

/// A goal to which one could slide, for a car: a slot of 1.4 m for 1 m of robot.
struct LongSearch : FrontEnd
{
  static OccupancyGrid hall()
  {
    OccupancyGrid grid = free_area(8.0, 6.0, 0.05);
    occupy_block(grid, 0, 80, 66, 40);
    occupy_block(grid, 94, 80, 66, 40);
    return grid;
  }

  const Site site{hall()};
  const PlanRequest request = {{1.5, 2.0, 0.0}, {4.0, 5.0, 0.0}, {Mode::ackermann}};
};

TEST_F(LongSearch, ExpandsNoMoreThanAllowed)
{
  for (int most : {1, 7, 100, 3000})
  {
    options.max_expansions = most;
    std::vector<Pose> expanded;
    const SearchResult result = Search(SearchProblem{site.checker, request.start, request.goal, Interrupt()})
                                    .find(options, request.modes, Effort::thorough, &expanded);
    EXPECT_EQ(result.status, PlanStatus::no_path);
    EXPECT_EQ(result.expansions, most);
    EXPECT_EQ(expanded.size(), static_cast<std::size_t>(most));
    EXPECT_TRUE(result.path.pieces.empty());
  }
}

TEST_F(LongSearch, StopsAtOnceWhenCancelled)
{
  const std::atomic<bool> cancelled{true};
  std::vector<Pose> expanded;
  const SearchResult result = find(site, request, Interrupt(&cancelled), &expanded);
  EXPECT_EQ(result.status, PlanStatus::cancelled);
  EXPECT_TRUE(expanded.empty());
  EXPECT_TRUE(result.path.pieces.empty());
}

TEST_F(LongSearch, StopsAtOnceWhenTheDeadlineHasPassed)
{
  const SearchResult result = find(site, request, Interrupt(nullptr, Interrupt::Clock::now()));
  EXPECT_EQ(result.status, PlanStatus::timeout);
  EXPECT_EQ(result.expansions, 0);
}

TEST_F(LongSearch, IsInterruptedInTheMiddleOfTheSearch)
{
  std::atomic<bool> cancelled{false};
  int asked = 0;
  const auto distance = [&](const Pose& pose) {
    cancelled = ++asked > 200;
    return fourwis::distance(pose, request.goal);
  };
  const SearchProblem problem = {site.checker, request.start, request.goal, Interrupt(&cancelled)};
  const SearchResult result = hybrid_astar(problem, options, request.modes, {distance});
  EXPECT_EQ(result.status, PlanStatus::cancelled);
  EXPECT_GT(result.expansions, 0);
}

TEST_F(FrontEnd, ProvesThatAWalledInGoalIsOutOfReach)
{
  OccupancyGrid grid = free_area(9.0, 6.0, 0.05);
  wall_in(grid, 100, 40, 60, 40);
  const Site site(grid);
  for (const ModeSet& modes : all_mode_sets())
  {
    const PlanRequest in = {{2.0, 3.0, 0.0}, {6.5, 3.0, 0.0}, modes}, out = {in.goal, in.start, modes};
    for (const PlanRequest& request : {in, out})
    {
      const SearchResult result = find(site, request);
      EXPECT_EQ(result.status, PlanStatus::goal_unreachable) << text(modes);
      EXPECT_EQ(result.expansions, 0);
    }
  }
}

TEST_F(FrontEnd, GoesThroughADoorThatOnlyTheBodyFitsAndProvesThatANarrowerOneIsClosed)
{
  options.max_expansions = 100000;
  const PlanRequest request = {{2.0, 3.0, 0.0}, {7.0, 3.0, 0.0}, {}};
  for (int cells : {12, 14, 16})
  {
    OccupancyGrid grid = free_area(9.0, 6.0, 0.05);
    occupy_block(grid, 90, 0, 1, 120);
    for (int row = 52; row < 52 + cells; ++row) cell(grid, 90, row) = 0;  // the two discs need 0.84 m, the body 0.66 m
    const Site site(grid);
    const CollisionChecker body(site.map, site.robot, {request.start, request.goal});
    const SearchResult result = find(body, request, Effort::thorough);
    if (cells == 12)
    {
      EXPECT_EQ(result.status, PlanStatus::goal_unreachable);
      EXPECT_EQ(result.expansions, 0);
      continue;
    }
    ASSERT_EQ(result.status, PlanStatus::succeeded) << cells << " cells";
    EXPECT_EQ(broken_law(result.path, body, site.robot, request.modes, request.start, request.goal), "")
        << text(result.path);
  }
}

/// Into a slot, where a search from the goal to the start is the easier one.
TEST_F(FrontEnd, FindsPathsBothWaysThatBeginAtTheStart)
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.05);
  occupy_block(grid, 0, 80, 66, 40);
  occupy_block(grid, 94, 80, 66, 40);
  const Site site(grid);
  options.max_expansions = 100000;
  for (const Pose& outside : {Pose{1.5, 2.0, 0.0}, Pose{6.5, 1.0, 2.0}})
    for (const bool inward : {false, true})
    {
      PlanRequest request = {outside, {4.0, 4.9, 0.0}, {Mode::ackermann, Mode::parallel}};
      if (!inward) std::swap(request.start, request.goal);
      const SearchResult result = find(site.checker, request, Effort::both_ways);
      ASSERT_EQ(result.status, PlanStatus::succeeded);
      expect_valid(site, request, result.path);
    }
}

TEST_F(FrontEnd, RefusesToTurnTheRobotByParallelMotionAlone)
{
  const Site site(free_area(9.0, 9.0, 0.1));
  const SearchResult result = find(site, {{3.0, 3.0, 0.0}, {6.0, 6.0, 1.0}, {Mode::parallel}});
  EXPECT_TRUE(result.status == PlanStatus::goal_unreachable || result.status == PlanStatus::no_path);
}

TEST_F(FrontEnd, SlidesSidewaysIntoASlotThatACarCanHardlyEnter)
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.05);
  occupy_block(grid, 0, 80, 66, 40);
  occupy_block(grid, 94, 80, 66, 40);  // 1.4 m between them, for 1 m of robot
  const Site site(grid);
  const PlanRequest request = {{1.5, 2.0, 0.0}, {4.0, 5.0, 0.0}, {}};
  const SearchResult found = find(site, request);
  ASSERT_EQ(found.status, PlanStatus::succeeded);
  expect_valid(site, request, found.path);
  const SearchResult car = find(site, {request.start, request.goal, {Mode::ackermann}});
  EXPECT_TRUE(car.status != PlanStatus::succeeded || car.path.cost > 2.0 * found.path.cost) << text(car.path);
}

TEST_F(FrontEnd, TurnsACarBetweenWallsThatLeaveItAFewCentimetres)
{
  const Site site(free_area(8.0, 1.45, 0.05));  // the two discs of a robot across take 1.34 m
  const PlanRequest request = {{4.0, 0.725, M_PI_2}, {1.5, 0.725, 0.0}, {Mode::ackermann}};
  options.max_expansions = 20000;
  const SearchResult found = find(site, request);
  ASSERT_EQ(found.status, PlanStatus::succeeded);
  expect_valid(site, request, found.path);
}

/// The paper's Table III: with and without terminal connection and switching awareness.
TEST_F(FrontEnd, FindsValidPathsInAllVariantsOfTheAblation)
{
  for (bool connect : {false, true})
    for (bool aware : {false, true})
    {
      options.terminal_connection = connect;
      options.switching_awareness = aware;
      int found = 0;
      for_requests(14, [&](const Site& site, const PlanRequest& request) {
        const SearchResult result = find(site, request);
        if (result.status != PlanStatus::succeeded) return;
        ++found;
        ASSERT_EQ(broken_law(result.path, site.checker, site.robot, request.modes), "");
        EXPECT_LE(distance(result.path.goal, request.goal), connect ? 1e-6 : options.xy_goal_tolerance);
        EXPECT_LE(heading_gap(result.path.goal.theta, request.goal.theta), connect ? 1e-6 : options.yaw_goal_tolerance);
      });
      EXPECT_GT(found, connect ? 7 : 1) << "connection " << connect << ", awareness " << aware;
    }
}

TEST_F(LongSearch, OptionsOutOfRangeAreRejectedByName)
{
  const auto distance = [](const Pose&) { return 0.0; };
  const SearchProblem problem{site.checker, request.start, request.goal, Interrupt()};
  for (const double bad : {0.0, -1.0, std::nan("")})
  {
    std::array<SearchOptions, 4> all;
    all[0].reference_speed = all[1].step_time = all[2].xy_resolution = all[3].heading_resolution = bad;
    for (const SearchOptions& changed : all)
    {
      options = changed;
      EXPECT_THROW(find(site, request), std::invalid_argument);
      EXPECT_THROW(hybrid_astar(problem, options, request.modes, {distance}), std::invalid_argument);
    }
  }
}

// A penalty that is no number once ended in a search that found nothing.
TEST_F(LongSearch, EveryOptionIsCheckedBeforeTheSearchBegins)
{
  const std::vector<std::pair<std::string, std::function<void(SearchOptions&)>>> cases = {
      {"parameter 'reverse_penalty' is nan, expected a number from 0 to 1000 m",
       [](SearchOptions& o) { o.reverse_penalty = std::nan(""); }},
      {"parameter 'heuristic_weight' is inf, expected a number from 0 to 100",
       [](SearchOptions& o) { o.heuristic_weight = INFINITY; }},
      {"parameter 'xy_resolution' is 0.001, expected a number from 0.01 to 5 m",
       [](SearchOptions& o) { o.xy_resolution = 0.001; }},
      {"parameter 'shortcut_passes' is -1, expected a whole number from 0 to 1000",
       [](SearchOptions& o) { o.shortcut_passes = -1; }}};
  const std::atomic<bool> cancelled{true};
  for (const auto& [said, change] : cases)
  {
    options = {};
    change(options);
    EXPECT_EQ(error_of<std::invalid_argument>([&] { find(site, request, Interrupt(&cancelled)); }), said);
  }
}

}  // namespace
}  // namespace fourwis
