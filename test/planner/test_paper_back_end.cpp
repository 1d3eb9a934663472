#include "planner/paper_back_end.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <limits>
#include <stdexcept>

#include "../segment/random_path.h"
#include "../support/grids.h"
#include "fourwis_navigation/search/search.h"
#include "fourwis_navigation/segment/segment.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 34;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A corridor from west to east, 2 m wide, in an area of 12 m x 4 m.
OccupancyGrid corridor_grid()
{
  OccupancyGrid grid = free_area(12.0, 4.0, 0.05);
  occupy_block(grid, 0, 0, 240, 20);
  occupy_block(grid, 0, 60, 240, 20);
  return grid;
}

struct PaperBackEndTest : testing::Test
{
  PaperRefinement refine(const Path& path, const Interrupt& interrupt = {})
  {
    return PaperBackEnd({world, planner_options, checker, interrupt, threads}, options).refine(path);
  }

  /// A weaving drive through the corridor.
  Path weaving(Mode mode) const
  {
    Path path = path_from({1.5, 2.0, mode == Mode::lateral ? -M_PI_2 : 0.0});
    for (double phi : {0.03, -0.03, -0.03, 0.03}) append(path, robot, mode, phi, 1.5);
    return path;
  }

  void expect_status(PaperStatus status, const Path& path)
  {
    const PaperRefinement refinement = refine(path);
    EXPECT_STREQ(to_string(refinement.status), to_string(status)) << refinement.message;
    EXPECT_FALSE(refinement.message.empty());
  }

  PlannerOptions planner_options;
  const World world{corridor_grid(), {}, planner_options};
  const Robot& robot = world.robot;
  const CollisionChecker checker{world.obstacles, robot};
  ThreadBudget threads;
  PaperBackEndOptions options;
};

TEST_F(PaperBackEndTest, ConvergesInASimpleCorridor)
{
  for (Mode mode : kPlannedModes)
  {
    SCOPED_TRACE(to_string(mode));
    const Path path = weaving(mode);
    const PaperRefinement refinement = refine(path);
    ASSERT_EQ(refinement.status, PaperStatus::converged) << refinement.message;
    EXPECT_LT(refinement.infeasibility, 1e-6);
    EXPECT_LE(refinement.outer_iterations, 10);
    EXPECT_GE(refinement.ipopt_iterations, refinement.outer_iterations);
    EXPECT_EQ(refinement.segments, 1);
    ASSERT_EQ(refinement.corridors.size(), 1u);
    const Trajectory& points = refinement.trajectory;
    ASSERT_EQ(points.size(), refinement.corridors[0].front.size());
    EXPECT_LT(distance(points.front().pose(), path.pieces.front().start), 1e-9);
    EXPECT_LT(distance(points.back().pose(), path.goal), 1e-9);
    EXPECT_GT(points.back().t, distance(path.pieces.front().start, path.goal) / robot.max_speed);
    // Boxes hold the discs at the knots, up to what psi allows.
    for (const TrajectoryPoint& p : points)
      for (double offset : {checker.discs().offset, -checker.discs().offset})
      {
        const Pose centre = compose(p.pose(), {offset, 0.0, 0.0});
        EXPECT_NEAR(centre.y, 2.0, 1.0 - checker.discs().radius + 2e-3);
      }
  }
}

TEST_F(PaperBackEndTest, JoinsSegmentsAtRestWithTheSwitchTime)
{
  Path path = path_from({1.5, 2.0, 0.0});
  append(path, robot, Mode::ackermann, 0.0, 3.0);
  append(path, robot, Mode::lateral, 0.0, 0.3);
  append(path, robot, Mode::parallel, -0.1, 3.0);
  const PaperRefinement refinement = refine(path);
  ASSERT_EQ(refinement.status, PaperStatus::converged) << refinement.message;
  EXPECT_EQ(refinement.segments, 3);
  EXPECT_EQ(refinement.corridors.size(), 3u);
  int switches = 0;
  for (std::size_t k = 1; k < refinement.trajectory.size(); ++k)
  {
    const TrajectoryPoint &p = refinement.trajectory[k - 1], &q = refinement.trajectory[k];
    EXPECT_GT(q.t, p.t);
    if (p.mode == q.mode) continue;
    ++switches;
    EXPECT_NEAR(q.t - p.t, robot.mode_switch_time, 1e-9);
    EXPECT_LT(distance(p.pose(), q.pose()), 1e-9);
    EXPECT_EQ(p.v, 0.0);
    EXPECT_EQ(q.v, 0.0);
  }
  EXPECT_EQ(switches, 2);
}

TEST_F(PaperBackEndTest, EndsWithAStatusOnPathsThroughRandomMaps)
{
  Random random(kSeed);
  SearchOptions search;
  search.max_expansions = 2000;
  int paths = 0, converged = 0, rebuilt = 0;
  for (int k = 0; k < 14; ++k)
  {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " map " << k);
    const World cluttered(clutter(random, 6.0, k % 2 == 0 ? 0.1 : 0.05, 6, random.pose(5.0)), robot, planner_options);
    const CollisionChecker free(cluttered.obstacles, robot);
    const Pose start = free_pose(random, free), goal = free_pose(random, free);
    const SearchResult found =
        Search({free, start, goal}).find(search, all_mode_sets()[static_cast<std::size_t>(k) % 7]);
    if (found.path.pieces.empty()) continue;
    ++paths;
    const PaperRefinement refinement =
        PaperBackEnd({cluttered, planner_options, free, {}, threads}, options).refine(found.path);
    converged += refinement.status == PaperStatus::converged;
    rebuilt += refinement.status == PaperStatus::converged && refinement.outer_iterations > 1;
    EXPECT_EQ(refinement.status == PaperStatus::converged, refinement.infeasibility < options.convergence)
        << refinement.message;
    EXPECT_LE(refinement.outer_iterations, options.outer_iterations);
    EXPECT_FALSE(refinement.message.empty());
    ASSERT_FALSE(refinement.trajectory.empty());
    for (const TrajectoryPoint& p : refinement.trajectory)
      ASSERT_TRUE(std::isfinite(p.t + p.x + p.y + p.theta + p.v + p.phi + p.a + p.omega));
  }
  EXPECT_GE(paths, 10);
  // Full lock over a few of Euler's steps has no solution: the paper's rounds are used up.
  EXPECT_GE(2 * converged, paths);
  EXPECT_GE(rebuilt, 1);
}

TEST_F(PaperBackEndTest, SaysWhyThereIsNoTrajectory)
{
  expect_status(PaperStatus::invalid_path, {});
  Path still = path_from({1.5, 2.0, 0.0});
  append(still, robot, Mode::ackermann, 0.1, 0.0);
  expect_status(PaperStatus::invalid_path, still);

  for (double bad : {kNaN, kInfinity})
  {
    Path path = weaving(Mode::ackermann);
    path.pieces[1].start.x = bad;
    expect_status(PaperStatus::invalid_path, path);
    path = weaving(Mode::ackermann);
    path.pieces[2].phi = bad;
    expect_status(PaperStatus::invalid_path, path);
  }

  Path through_wall = path_from({1.5, 2.0, 0.0});
  append(through_wall, robot, Mode::lateral, 0.0, 1.8);
  expect_status(PaperStatus::corridor, through_wall);
  Path out_of_map = path_from({11.0, 2.0, 0.0});
  append(out_of_map, robot, Mode::ackermann, 0.0, 3.0);
  expect_status(PaperStatus::corridor, out_of_map);
}

TEST_F(PaperBackEndTest, ManagesAMillimetre)
{
  Path path = path_from({1.5, 2.0, 0.0});
  append(path, robot, Mode::parallel, 0.1, 0.001);
  const PaperRefinement refinement = refine(path);
  EXPECT_EQ(refinement.status, PaperStatus::converged) << refinement.message;
  EXPECT_LT(distance(refinement.trajectory.back().pose(), path.goal), 1e-9);
}

TEST_F(PaperBackEndTest, StopsWhenInterrupted)
{
  const std::atomic<bool> cancelled{true};
  EXPECT_EQ(refine(weaving(Mode::ackermann), Interrupt(&cancelled)).status, PaperStatus::interrupted);
  const Interrupt late(nullptr, Interrupt::Clock::now());
  EXPECT_EQ(refine(weaving(Mode::ackermann), late).status, PaperStatus::interrupted);
}

TEST_F(PaperBackEndTest, RejectsOptionsOutOfRange)
{
  const auto expect_refused = [&](const std::function<void(PaperBackEndOptions&)>& change) {
    PaperBackEndOptions changed;
    change(changed);
    EXPECT_THROW(PaperBackEnd({world, planner_options, checker, {}, threads}, changed).refine(weaving(Mode::ackermann)),
                 std::invalid_argument);
  };
  expect_refused([](PaperBackEndOptions& o) { o.spacing = 0.0; });
  expect_refused([](PaperBackEndOptions& o) { o.convergence = kNaN; });
  expect_refused([](PaperBackEndOptions& o) { o.outer_iterations = 0; });
  expect_refused([](PaperBackEndOptions& o) { o.boxes.fine_step = -1.0; });
  expect_refused([](PaperBackEndOptions& o) { o.program.penalty = 0.0; });
  planner_options.search.reference_speed = 0.0;
  EXPECT_THROW(refine(weaving(Mode::ackermann)), std::invalid_argument);
}

}  // namespace
}  // namespace fourwis
