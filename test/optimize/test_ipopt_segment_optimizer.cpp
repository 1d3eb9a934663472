#include "fourwis_navigation/optimize/ipopt_segment_optimizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <limits>

#include "../support/grids.h"
#include "fourwis_navigation/corridor/polytope_corridor.h"
#include "fourwis_navigation/search/search.h"
#include "fourwis_navigation/segment/segment.h"
#include "optimize/ipopt_solver.h"
#include "optimize/ocp_nlp.h"
#include "optimize/segment_problem.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 33;
constexpr double kTolerance = 1e-7, kSameDuration = 1e-4, kSpeed = 1.0;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double duration(const SegmentSolution& solution)
{
  return solution.points.back().t;
}

/// A metre straight ahead through a wide corridor.
struct Straight
{
  Segment segment = {Mode::ackermann, {}, {0, 0, 0, 0, 0}, {0.2, 0.2, 0.2, 0.2, 0.2}};
  Corridor corridor;

  Straight()
  {
    const Polytope wide = {{1, 0, 3}, {-1, 0, 3}, {0, 1, 3}, {0, -1, 3}};
    for (int k = 0; k <= 5; ++k) segment.knots.push_back({0.2 * k, 0.0, 0.0});
    for (double offset : {0.25, -0.25}) corridor.push_back({{offset, 0.0}, std::vector<Polytope>(5, wide)});
  }
};

struct IpoptSegmentOptimizerTest : testing::Test
{
  /// Visits segments of paths through random maps with the corridors around them.
  template <typename Visit>
  void for_segments(int maps, Visit visit) const
  {
    Random random(kSeed);
    SearchOptions search;
    search.max_expansions = 2000;
    for (int k = 0; k < maps; ++k)
    {
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << " map " << k);
      const Site site(clutter(random, 6.0, k % 2 == 0 ? 0.1 : 0.05, 6, random.pose(5.0)));
      const ModeSet modes = all_mode_sets()[static_cast<std::size_t>(k) % 7];
      const PlanRequest request = {free_pose(random, site.checker), free_pose(random, site.checker), modes};
      const Path path = Search({site.checker, request.start, request.goal}).find(search, modes).path;
      for (const Segment& segment : split_at_switches(path, robot, options.knot_spacing(robot)))
      {
        const PolytopeCorridor corridor =
            polytope_corridor(ObstacleRectangles(site.map), disc_cover(robot, 2), {}, segment.knots);
        if (corridor.status == CorridorStatus::succeeded) visit(segment, corridor.regions);
      }
    }
  }

  /// Duration of what Ipopt finds from another solver's points.
  double improved_duration(const Segment& segment, const Corridor& corridor, const Trajectory& points) const
  {
    const MotionLimits limits(robot, segment.mode);
    const auto problem = segment_problem<WheelSpeedRows>({segment, corridor}, robot, options, limits, kSpeed);
    const OcpNlp<SegmentModel<WheelSpeedRows>> program(problem.model, problem.numbers, guess_from(points));
    IpoptOptions nearby;
    nearby.tolerance = kTolerance;
    nearby.initial_barrier = nearby.bound_distance = 1e-6;
    const NlpResult result = solve_on_ipopt(program.nlp(), nearby, {});
    EXPECT_TRUE(is_solved(result.status)) << to_string(result.status);
    return points_of(program.trajectory(result.x), segment.mode).back().t;
  }

  /// A straight metre with something changed is not solved, for the given reason.
  void expect_refused(const char* message, const std::function<void(Straight&)>& change) const
  {
    Straight problem;
    change(problem);
    const SegmentSolution solution = ipopt.solve({problem.segment, problem.corridor}, kTolerance, {});
    EXPECT_FALSE(solution.solved);
    EXPECT_EQ(solution.message, message);
  }

  const Robot robot;
  const OptimizeOptions options;
  const SegmentOptimizer structured{robot, options, kSpeed};
  const IpoptSegmentOptimizer ipopt{robot, options, kSpeed};
};

TEST_F(IpoptSegmentOptimizerTest, TakesAsLongAsTheStructuredSolver)
{
  std::array<int, 4> solved = {};
  int count = 0, both = 0, same = 0;
  for_segments(70, [&](const Segment& segment, const Corridor& corridor) {
    const SegmentSolution one = structured.solve({segment, corridor}, kTolerance, {});
    const SegmentSolution other = ipopt.solve({segment, corridor}, kTolerance, {});
    ++count;
    if (!one.solved || !other.solved) return;
    ++both;
    ++solved[static_cast<std::size_t>(segment.mode)];
    // There may be several ways, each of them the best nearby: then Ipopt has nothing to add to the one found.
    same += std::abs(duration(one) - duration(other)) <= kSameDuration;
    EXPECT_NEAR(improved_duration(segment, corridor, one.points), duration(one), kSameDuration);
    EXPECT_LT(std::max(one.corridor_violation, other.corridor_violation), 1e-4);
  });
  for (Mode mode : kPlannedModes) EXPECT_GE(solved[static_cast<std::size_t>(mode)], 8) << to_string(mode);
  EXPECT_GE(both, 0.95 * count) << "of " << count;
  EXPECT_GE(same, 0.9 * both) << "of " << both;
}

TEST_F(IpoptSegmentOptimizerTest, AgreesAboutStopsAndAboutEarlierSolutions)
{
  const Straight problem;
  const std::vector<char> stop = {0, 0, 0, 1, 0, 0};
  const SegmentSolution free = ipopt.solve({problem.segment, problem.corridor}, kTolerance, {});
  const SegmentSolution one = structured.solve({problem.segment, problem.corridor, nullptr, stop}, kTolerance, {});
  const SegmentSolution other = ipopt.solve({problem.segment, problem.corridor, nullptr, stop}, kTolerance, {});
  ASSERT_TRUE(free.solved && one.solved && other.solved) << free.message << one.message << other.message;
  EXPECT_NEAR(duration(one), duration(other), kSameDuration);
  EXPECT_GT(duration(other), duration(free) + 0.1);
  EXPECT_NEAR(other.points[3].v, 0.0, 0.01);

  const SegmentSolution again = ipopt.solve({problem.segment, problem.corridor, &free.points}, kTolerance, {});
  EXPECT_TRUE(again.solved);
  EXPECT_NEAR(duration(again), duration(free), kSameDuration);
}

TEST_F(IpoptSegmentOptimizerTest, SaysThatAProblemMakesNoSense)
{
  expect_refused("invalid_problem", [](Straight& p) { p.segment = {}; });
  expect_refused("invalid_problem", [](Straight& p) { p.segment.mode = Mode::spin; });
  expect_refused("invalid_problem", [](Straight& p) { p.segment.knots.pop_back(); });
  expect_refused("invalid_problem", [](Straight& p) { p.segment.length.pop_back(); });
  expect_refused("invalid_problem", [](Straight& p) { p.corridor[0].regions.pop_back(); });
  expect_refused("invalid_problem", [](Straight& p) { p.corridor = {}; });
  for (double bad : {kNaN, kInfinity})
  {
    expect_refused("invalid_problem", [&](Straight& p) { p.segment.knots[0].x = bad; });
    expect_refused("invalid_problem", [&](Straight& p) { p.segment.knots[2].theta = bad; });
    expect_refused("invalid_problem", [&](Straight& p) { p.segment.phi[0] = bad; });
    expect_refused("invalid_problem", [&](Straight& p) { p.segment.length[3] = bad; });
  }
  expect_refused("invalid_problem", [](Straight& p) { p.corridor[1].regions[1][0].c = kNaN; });
}

TEST_F(IpoptSegmentOptimizerTest, IsNotSolvedWhereTheGoalIsOutOfReachOrItIsInterrupted)
{
  expect_refused("infeasible", [](Straight& p) { p.segment.knots.back() = {0.2, 4.0, 3.0}; });

  const Straight problem;
  const std::atomic<bool> cancelled{true};
  const SegmentSolution stopped = ipopt.solve({problem.segment, problem.corridor}, kTolerance, Interrupt(&cancelled));
  EXPECT_FALSE(stopped.solved);
  EXPECT_EQ(stopped.message, "interrupted");
  EXPECT_EQ(stopped.points.size(), problem.segment.knots.size());
}

}  // namespace
}  // namespace fourwis
