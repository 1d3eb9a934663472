#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../support/grids.h"
#include "../support/sentences.h"
#include "fourwis_navigation/planner/planner.h"
#include "planner/candidates.h"
#include "planner/segment_refiner.h"

namespace fourwis
{
namespace
{

struct Case
{
  std::string said;
  std::function<void(PlannerOptions&)> change;
};

/// One of each struct that PlannerOptions is made of, and all that once passed without a word.
const std::vector<Case>& cases()
{
  using O = PlannerOptions;
  static const std::vector<Case> all = {
      {"'corridor_discs' is 0, expected a whole number from 1 to 8", [](O& o) { o.optimize.corridor_discs = 0; }},
      {"'xy_resolution' is 0, expected a number from 0.01 to 5 m", [](O& o) { o.search.xy_resolution = 0.0; }},
      {"'reference_speed' is 0, expected a number from 0.01 to 20 m/s", [](O& o) { o.search.reference_speed = 0.0; }},
      {"'max_expansions' is 0, ", [](O& o) { o.search.max_expansions = 0; }},
      {"'knot_spacing' is nan, ", [](O& o) { o.optimize.spacing = NAN; }},
      {"'solver' is '', expected one of structured, ipopt",
       [](O& o) { o.optimize.solver = static_cast<NlpSolver>(2); }},
      {"'occupied_threshold' is 101, ", [](O& o) { o.obstacles.occupied_threshold = 101; }},
      {"'collision_step' is 0.02, ", [](O& o) { o.referee.collision_step = 0.02; }},
      {"'rollout_angle' is -1, ", [](O& o) { o.referee.rollout_angle = -1.0; }},
      {"'planner_patience' is -inf, ", [](O& o) { o.planner_patience = -INFINITY; }}};
  return all;
}

TEST(PlannerOptions, OutOfRangeAreRejectedByNameByPlannerAndWorld)
{
  const OccupancyGrid grid = free_area(2.0, 2.0, 0.1);
  for (const Case& bad : cases())
  {
    PlannerOptions options;
    bad.change(options);
    EXPECT_TRUE(says(error_of<std::invalid_argument>([&] { Planner{options}; }), bad.said));
    EXPECT_TRUE(says(error_of<std::invalid_argument>([&] { World(grid, {}, options); }), bad.said));
  }
}

TEST(PlannerOptions, NoWorldHasARobotWithWheelsOutsideItsBody)
{
  Robot robot;
  robot.width = 0.5;
  const std::string said = "'track_width' is 0.52, expected at most 'width' (0.5 m)";
  EXPECT_TRUE(says(error_of<std::invalid_argument>([&] { World(free_area(2.0, 2.0, 0.1), robot, {}); }), said));
}

// Search::find() checks what the planner makes of them.
TEST(PlannerOptions, StayInTheirRangesWhenPenaltiesBecomeTimes)
{
  Robot robot;
  robot.max_speed = 20.0;
  robot.max_acceleration = 0.01;
  SearchOptions options;
  options.reverse_penalty = options.steering_penalty = 1000.0;
  options.direction_change_penalty = 1e5;
  check(robot);
  check(options);
  for (const SearchVariant& variant : variants_by_time(robot, options, ModeSet(), Effort::quick))
    EXPECT_NO_THROW(check(variant.options)) << variant.name;
}

TEST(PlannerOptions, OfTheBackEndAloneAreCheckedByIt)
{
  const OccupancyGrid grid = free_area(2.0, 2.0, 0.1);
  const World world(grid, {}, {});
  const CollisionChecker checker(world.obstacles, world.robot);
  ThreadBudget threads(1);
  const auto said = [&](const PlannerOptions& options) {
    const PlanContext context{world, options, checker, {}, threads};
    return error_of<std::invalid_argument>([&] { SegmentRefiner{context}; });
  };
  const auto said_alone = [](const OptimizeOptions& options, double speed) {
    const Robot robot;
    const std::string text = error_of<std::invalid_argument>([&] { SegmentOptimizer(robot, options, speed); });
    EXPECT_EQ(error_of<std::invalid_argument>([&] { IpoptSegmentOptimizer(robot, options, speed); }), text);
    return text;
  };
  PlannerOptions options;
  EXPECT_EQ(said(options), "");
  EXPECT_EQ(said_alone(options.optimize, 1.0), "");
  options.search.reference_speed = 0.0;
  EXPECT_TRUE(says(said(options), "'reference_speed' is 0, expected a positive"));
  EXPECT_TRUE(says(said_alone(options.optimize, 0.0), "'reference_speed' is 0, expected a positive"));
  options.search.reference_speed = 1.0;
  options.optimize.corridor_discs = 0;
  EXPECT_TRUE(says(said(options), "'corridor_discs' is 0"));
  EXPECT_TRUE(says(said_alone(options.optimize, 1.0), "'corridor_discs' is 0"));
}

}  // namespace
}  // namespace fourwis
