#pragma once

#include <atomic>

#include <ros/time.h>

#include "fourwis_navigation/planner/planner.h"
#include "map_store.h"

namespace fourwis
{

/// A question, the planner's answer, and what it was answered on.
struct PlanAnswer
{
  PlanRequest request;
  PlanResult result;
  PlanTrace trace;      ///< empty unless asked for
  ros::Time map_stamp;  ///< of the map it was planned on
};

/// Plans on the newest map, for goals and services alike. Safe to use from several threads at once.
class MapPlanner
{
public:
  /// `maps` must outlive this. `traced`: whether answers carry a trace.
  MapPlanner(const Planner& planner, const MapStore& maps, bool traced);

  /// Waits for a map that is being built. A map that arrives while it plans does not touch it. Never throws.
  /// Planner::judge_goal() on the newest map; `succeeded` also where there is none yet.
  PlanAnswer judge_goal(const Pose& goal) const;

  PlanAnswer plan(const PlanRequest& request, const std::atomic<bool>& cancelled) const;

private:
  const Planner planner_;
  const MapStore& maps_;
  const bool traced_;
};

}  // namespace fourwis
