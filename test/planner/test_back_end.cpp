#include "planner/back_end.h"

#include <gtest/gtest.h>

#include <atomic>

#include "../support/grids.h"
#include "fourwis_navigation/referee/referee.h"
#include "fourwis_navigation/search/front_end.h"
#include "planner/stop_and_steer.h"

namespace fourwis
{
namespace
{

constexpr unsigned kFirstSeed = 1;
constexpr int kSeeds = 1000;
constexpr double kSpeed = 1.0;

bool same(const Trajectory& a, const Trajectory& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const TrajectoryPoint& p, const TrajectoryPoint& q) {
    return p.t == q.t && p.mode == q.mode && p.x == q.x && p.y == q.y && p.theta == q.theta && p.v == q.v &&
           p.phi == q.phi && p.a == q.a && p.omega == q.omega;
  });
}

/// A random problem that the front end solves, with what the back end needs.
struct Scene
{
  Scene(unsigned seed, double resolution, const Robot& robot)
    : random(seed),
      grid(clutter(random, 9.0, resolution, 10, random.pose(5.0))),
      map(grid),
      checker(map, robot),
      obstacles(map)
  {
    request.start = free_pose(random, checker);
    request.goal = free_pose(random, checker);
    const std::vector<ModeSet> sets = all_mode_sets();
    request.modes = sets[seed % sets.size()];
    found = find_path(checker, robot, options, request, Interrupt());
  }

  Random random;
  OccupancyGrid grid;
  ObstacleMap map;
  CollisionChecker checker;
  ObstacleRectangles obstacles;
  SearchOptions options;
  PlanRequest request;
  SearchResult found;
};

struct BackEnd : testing::Test
{
  Refinement refine(const Scene& scene, const Interrupt& interrupt = {}) const
  {
    return fourwis::refine(scene.checker, scene.obstacles, robot, options, kSpeed, scene.found.path, interrupt);
  }

  /// Visits the scenes whose path is found.
  template <typename Visit>
  void for_scenes(int count, Visit visit) const
  {
    int visited = 0;
    for (unsigned seed = kFirstSeed; seed < kFirstSeed + static_cast<unsigned>(count); ++seed)
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      const Scene scene(seed, seed % 2 ? 0.05 : 0.1, robot);
      if (scene.found.status != PlanStatus::succeeded || scene.found.path.pieces.empty()) continue;
      ++visited;
      visit(scene);
    }
    EXPECT_GT(visited, count / 2);
  }

  const Robot robot;
  const OptimizeOptions options;
};

TEST_F(BackEnd, OptimisesEverySegmentOfRandomPathsIntoWhatTheRefereeAccepts)
{
  for_scenes(kSeeds, [&](const Scene& scene) {
    const Refinement refinement = refine(scene);
    EXPECT_EQ(refinement.fallbacks, 0) << refinement.message;
    const Verdict verdict = Referee(scene.grid, ObstacleRule(), robot)
                                .judge(scene.request.start, scene.request.goal, refinement.trajectory);
    EXPECT_TRUE(verdict.accepted()) << verdict.violations.front().what;
    EXPECT_LE(verdict.terminal_position_error, 1e-4);
  });
}

TEST_F(BackEnd, IsNeverSlowerThanStoppingToSteer)
{
  for_scenes(40, [&](const Scene& scene) {
    const double with_stops = stop_and_steer(scene.found.path, robot, kSpeed).back().t;
    EXPECT_LE(refine(scene).trajectory.back().t, with_stops * 1.001 + 0.01);
  });
}

TEST_F(BackEnd, PolishingArrivesEarlierOrChangesNothing)
{
  int earlier = 0, scenes = 0;
  for_scenes(200, [&](const Scene& scene) {
    const Refinement before = refine(scene);
    Refinement after = before;
    polish(scene.checker, scene.obstacles, robot, options, kSpeed, {}, after);
    const bool is_earlier = after.trajectory.back().t < before.trajectory.back().t;
    EXPECT_TRUE(is_earlier || same(after.trajectory, before.trajectory));
    ++scenes;
    earlier += is_earlier;
    const Verdict verdict =
        Referee(scene.grid, ObstacleRule(), robot).judge(scene.request.start, scene.request.goal, after.trajectory);
    EXPECT_TRUE(verdict.accepted()) << verdict.violations.front().what;
  });
  EXPECT_GT(earlier, scenes / 4) << "of " << scenes;
}

TEST_F(BackEnd, GivesTheSameAnswerEachTime)
{
  for_scenes(20, [&](const Scene& scene) { EXPECT_TRUE(same(refine(scene).trajectory, refine(scene).trajectory)); });
}

TEST_F(BackEnd, AnswersNothingWhenCancelled)
{
  const std::atomic<bool> cancelled{true};
  const Scene scene(kFirstSeed + 6, 0.1, robot);
  ASSERT_EQ(scene.found.status, PlanStatus::succeeded);
  EXPECT_TRUE(refine(scene, Interrupt(&cancelled)).trajectory.empty());
}

TEST_F(BackEnd, StopsToSteerWhenTheTimeIsOver)
{
  const Scene scene(kFirstSeed + 6, 0.1, robot);
  ASSERT_EQ(scene.found.status, PlanStatus::succeeded);
  const Refinement late = refine(scene, Interrupt(nullptr, Interrupt::Clock::now()));
  EXPECT_EQ(late.fallbacks, static_cast<int>(late.parts.size()));
  EXPECT_TRUE(Referee(scene.grid, ObstacleRule(), robot)
                  .judge(scene.request.start, scene.request.goal, late.trajectory)
                  .accepted());
}

}  // namespace
}  // namespace fourwis
