#include "planner/candidates.h"

#include <gtest/gtest.h>

#include <set>

#include "../support/grids.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 61;

PlanResult plan(const World& world, const PlannerOptions& options, const Pose& start, const Pose& goal,
                const ModeSet& modes = {})
{
  return Planner(options).plan(world, {start, goal, modes});
}

/// A robot that turns in wide curves only: often it is faster sideways.
Robot stiff()
{
  Robot robot;
  robot.max_steering_angle = 0.2;
  robot.mode_switch_time = 1.5;
  return robot;
}

TEST(Variants, OfFewerModesAreVariantsOfMore)
{
  const auto of = [](const ModeSet& modes) {
    std::set<std::string> seen;
    for (const SearchVariant& variant : variants_by_time(Robot(), {}, modes, Effort::quick))
      seen.insert(text(variant.modes));
    return seen;
  };
  for (const ModeSet& more : all_mode_sets())
    for (const ModeSet& fewer : all_mode_sets())
    {
      if ((fewer & more) != fewer) continue;
      const std::set<std::string> known = of(more);
      for (const std::string& modes : of(fewer)) EXPECT_EQ(known.count(modes), 1u) << text(more) << " lacks " << modes;
    }
}

TEST(Portfolio, OfAllModesArrivesNoLaterThanThatOfFewerInAHall)
{
  Random random(kSeed);
  PlannerOptions options;
  options.planner_patience = 60.0;
  int gains = 0;
  for (int k = 0; k < 12; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", hall " + std::to_string(k));
    const World world(clutter(random, 8.0, 0.05, 3), stiff(), options);
    const CollisionChecker checker(world.obstacles, world.robot);
    const Pose start = free_pose(random, checker), goal = free_pose(random, checker);
    const PlanResult all = plan(world, options, start, goal);
    ASSERT_EQ(all.status, PlanStatus::succeeded) << all.message;
    double alone = 0.0;
    for (const ModeSet& modes : all_mode_sets())
    {
      const PlanResult fewer = plan(world, options, start, goal, modes);
      if (fewer.status != PlanStatus::succeeded) continue;
      EXPECT_LE(all.metrics.arrival_time, 1.01 * fewer.metrics.arrival_time) << text(modes) << " is faster";
      if (modes == ModeSet{Mode::ackermann}) alone = fewer.metrics.arrival_time;
    }
    gains += all.metrics.arrival_time < 0.9 * alone;
  }
  EXPECT_GT(gains, 2) << "halls in which Ackermann motion alone is slower";
}

TEST(LeastTime, IsNoMoreThanThatOfAPlan)
{
  Random random(kSeed);
  PlannerOptions options;
  options.planner_patience = 60.0;
  int switches = 0;
  for (int k = 0; k < 12; ++k)
  {
    const World world(clutter(random, 8.0, 0.05, 10), {}, options);
    const CollisionChecker checker(world.obstacles, world.robot);
    const Pose start = free_pose(random, checker), goal = free_pose(random, checker);
    const PlanResult result = plan(world, options, start, goal, {Mode::lateral, Mode::parallel});
    if (result.status != PlanStatus::succeeded) continue;
    EXPECT_LE(least_time(world.robot, result.path), result.metrics.arrival_time + 1e-9);
    EXPECT_GE(least_time(world.robot, result.path), distance(start, goal) / world.robot.max_speed);
    switches += result.path.switches();
  }
  EXPECT_GT(switches, 1);
}

TEST(LeastTime, OfAStraightWayIsThatOfRampsAndCruise)
{
  const Robot robot;
  Path path;
  path.pieces = {{Mode::ackermann, {1.0, 1.0, 0.0}, 0.0, 3.0}};
  path.goal = {4.0, 1.0, 0.0};
  EXPECT_NEAR(least_time(robot, path), 3.0 / 1.0 + 1.0 / 5.0, 1e-12);
  path.pieces.push_back({Mode::lateral, {4.0, 1.0, 0.0}, 0.0, 0.05});
  path.goal = {4.0, 1.05, 0.0};
  EXPECT_NEAR(least_time(robot, path), 3.2 + 0.4 + 2.0 * std::sqrt(0.05 / 5.0), 1e-12);
  EXPECT_EQ(least_time(robot, {}), 0.0);
}

TEST(WideCurves, AreForRobotsThatSteerSlowlyAndAreNeverTighter)
{
  EXPECT_FALSE(steers_slowly(Robot(), {}));
  Robot car;
  car.length = 4.689, car.width = 1.942, car.wheelbase = 2.8, car.track_width = 1.6;
  car.max_steering_angle = 0.75, car.max_steering_rate = 0.5, car.max_speed = 2.5, car.wheel_max_speed = 6.0;
  EXPECT_TRUE(steers_slowly(car, {}));
  for (double angle : {0.01, 0.0125, 0.3, 1.39})
  {
    car.max_steering_angle = angle;
    const Robot wide = with_wide_curves(car);
    EXPECT_LE(wide.max_steering_angle, angle);
    EXPECT_NO_THROW(check(wide)) << angle;
  }
}

}  // namespace
}  // namespace fourwis
