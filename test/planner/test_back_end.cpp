#include "planner/back_end.h"

#include <gtest/gtest.h>

#include <atomic>

#include "../support/grids.h"
#include "fourwis_navigation/search/search.h"
#include "planner/stop_and_steer.h"

namespace fourwis
{
namespace
{

constexpr unsigned kFirstSeed = 1;
constexpr int kSeeds = 1000;

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
      world(clutter(random, 9.0, resolution, 10, random.pose(5.0)), robot, {}),
      checker(world.obstacles, world.robot)
  {
    request.start = free_pose(random, checker);
    request.goal = free_pose(random, checker);
    const std::vector<ModeSet> sets = all_mode_sets();
    request.modes = sets[seed % sets.size()];
    found = Search({checker, request.start, request.goal}).find({}, request.modes);
  }

  Verdict judge(const Trajectory& trajectory) const
  {
    return world.referee.judge(request.start, request.goal, trajectory);
  }

  Random random;
  World world;
  CollisionChecker checker;
  PlanRequest request;
  SearchResult found;
};

struct BackEndTest : testing::Test
{
  BackEnd back_end(const Scene& scene, const Interrupt& interrupt = {})
  {
    return BackEnd({scene.world, options, scene.checker, interrupt, threads});
  }
  Refinement refine(const Scene& scene, const Interrupt& interrupt = {})
  {
    return back_end(scene, interrupt).refine(scene.found.path);
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
  const PlannerOptions options;
  ThreadBudget threads;
};

TEST_F(BackEndTest, OptimisesEverySegmentOfRandomPathsIntoWhatTheRefereeAccepts)
{
  for_scenes(kSeeds, [&](const Scene& scene) {
    const Refinement refinement = refine(scene);
    EXPECT_EQ(refinement.fallbacks, 0) << refinement.message;
    const Verdict verdict = scene.judge(refinement.trajectory);
    EXPECT_TRUE(verdict.accepted()) << verdict.violations.front().what;
    EXPECT_LE(verdict.terminal_position_error, 1e-4);
  });
}

TEST_F(BackEndTest, IsNeverSlowerThanStoppingToSteer)
{
  for_scenes(40, [&](const Scene& scene) {
    const double with_stops = stop_and_steer(scene.found.path, robot).back().t;
    EXPECT_LE(refine(scene).trajectory.back().t, with_stops * 1.001 + 0.01);
  });
}

TEST_F(BackEndTest, PolishingArrivesEarlierOrChangesNothing)
{
  int earlier = 0, scenes = 0;
  for_scenes(200, [&](const Scene& scene) {
    const Refinement before = refine(scene);
    Refinement after = before;
    back_end(scene).polish(after);
    const bool is_earlier = after.trajectory.back().t < before.trajectory.back().t;
    EXPECT_TRUE(is_earlier || same(after.trajectory, before.trajectory));
    ++scenes;
    earlier += is_earlier;
    const Verdict verdict = scene.judge(after.trajectory);
    EXPECT_TRUE(verdict.accepted()) << verdict.violations.front().what;
  });
  EXPECT_GT(earlier, scenes / 4) << "of " << scenes;
}

TEST_F(BackEndTest, GivesTheSameAnswerEachTime)
{
  for_scenes(20, [&](const Scene& scene) { EXPECT_TRUE(same(refine(scene).trajectory, refine(scene).trajectory)); });
}

TEST_F(BackEndTest, GivesTheSameAnswerWithAnyNumberOfThreads)
{
  for_scenes(20, [&](const Scene& scene) {
    ThreadBudget one(1);
    const BackEnd alone({scene.world, options, scene.checker, {}, one});
    Refinement expected = alone.refine(scene.found.path);
    const Trajectory refined = expected.trajectory;
    alone.polish(expected);
    for (int count : {2, 8})
    {
      ThreadBudget several(count);
      const BackEnd shared({scene.world, options, scene.checker, {}, several});
      Refinement refinement = shared.refine(scene.found.path);
      EXPECT_TRUE(same(refinement.trajectory, refined)) << count << " threads";
      shared.polish(refinement);
      EXPECT_TRUE(same(refinement.trajectory, expected.trajectory)) << count << " threads";
      EXPECT_EQ(refinement.solver_iterations, expected.solver_iterations);
    }
  });
}

TEST_F(BackEndTest, AnswersNothingWhenCancelled)
{
  const std::atomic<bool> cancelled{true};
  const Scene scene(kFirstSeed + 6, 0.1, robot);
  ASSERT_EQ(scene.found.status, PlanStatus::succeeded);
  EXPECT_TRUE(refine(scene, Interrupt(&cancelled)).trajectory.empty());
}

TEST_F(BackEndTest, StopsToSteerWhenTheTimeIsOver)
{
  const Scene scene(kFirstSeed + 6, 0.1, robot);
  ASSERT_EQ(scene.found.status, PlanStatus::succeeded);
  const Refinement late = refine(scene, Interrupt(nullptr, Interrupt::Clock::now()));
  EXPECT_EQ(late.fallbacks, static_cast<int>(late.parts.size()));
  EXPECT_TRUE(scene.judge(late.trajectory).accepted());
}

}  // namespace
}  // namespace fourwis
