#pragma once

#include <optional>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/planner/planner.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "plan_context.h"

namespace fourwis
{

/// The start, or where the way out of the obstacles that it overlaps ends.
inline Pose start_of(const Robot& robot, const PlanRequest& request, const std::optional<PathPiece>& way_out)
{
  if (!way_out) return request.start;
  return advance(robot, way_out->start, way_out->mode, way_out->phi, way_out->length);
}

/// What a plan is about.
struct Question
{
  const World& world;
  const PlannerOptions& options;
  const PlanRequest& request;  ///< in the frame of the world's grid
  const PlanRequest& asked;    ///< the same in the map frame
  Interrupt interrupt;
  ThreadBudget& threads;
  PlanTrace* trace;
};

/// What decides which poses are free.
struct Checkers
{
  const CollisionChecker& all;   ///< for the robot
  const CollisionChecker* wide;  ///< for the same with wide curves, where it steers slowly
};

/// The same with that, from a start that is free.
struct Task
{
  Task(const Question& question, const std::optional<PathPiece>& way_out_of_obstacles, const Checkers& checkers)
    : context{question.world, question.options, checkers.all, question.interrupt, question.threads},
      wide_curves(checkers.wide),
      request(question.request),
      asked(question.asked),
      way_out(way_out_of_obstacles),
      trace(question.trace)
  {}

  PlanContext context;
  const CollisionChecker* wide_curves;
  const PlanRequest& request;
  const PlanRequest& asked;
  const std::optional<PathPiece>& way_out;  ///< of obstacles that the body overlaps at the start
  PlanTrace* trace;

  /// Where the search begins.
  Pose start() const { return start_of(context.robot(), request, way_out); }
};

inline bool is_paper(const PlannerOptions& options)
{
  return options.optimize.formulation == Formulation::paper;
}

}  // namespace fourwis
