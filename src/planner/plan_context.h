#pragma once

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/planner/planner.h"
#include "thread_budget.h"

namespace fourwis
{

/// What stays the same during a plan. All it refers to must outlive it.
struct PlanContext
{
  const World& world;
  const PlannerOptions& options;
  const CollisionChecker& checker;  ///< of the world's robot on the world's map: which poses are free
  Interrupt interrupt;
  ThreadBudget& threads;

  const Robot& robot() const { return world.robot; }
  double reference_speed() const { return options.search.v_ref(world.robot); }
};

}  // namespace fourwis
