#pragma once

#include <gtest/gtest.h>

#include "../support/grids.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{

/// A robot, the options of its planner, and plans with them.
struct PlannerFixture : testing::Test
{
  PlannerFixture() { options.search.max_expansions = 3000; }

  PlanResult plan(const World& world, const PlanRequest& request, const Interrupt& interrupt = {},
                  PlanTrace* trace = nullptr) const
  {
    return Planner(options).plan(world, request, interrupt, trace);
  }

  /// A plan across an empty hall with something changed.
  PlanResult plan_in_hall(const Pose& start, const Pose& goal, const ModeSet& modes = {},
                          const Interrupt& interrupt = {}, bool frontend_only = false) const
  {
    return plan(World(free_area(8.0, 6.0, 0.1), robot, options), {start, goal, modes, frontend_only}, interrupt);
  }

  static void expect_refused(const PlanResult& result, PlanStatus status)
  {
    EXPECT_STREQ(to_string(result.status), to_string(status));
    EXPECT_FALSE(result.message.empty());
    EXPECT_TRUE(result.trajectory.empty());
    EXPECT_FALSE(result.metrics.safe);
  }

  const Robot robot;
  PlannerOptions options;
  const Pose here = {2.0, 3.0, 0.3}, there = {6.0, 3.0, -2.0};
};

}  // namespace fourwis
