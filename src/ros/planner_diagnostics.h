#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include "map_store.h"
#include "planner_topics.h"

namespace fourwis
{

/// Whether there is a map, and what became of the last request, on `/diagnostics`: WARN without a map and after a
/// failure.
class PlannerDiagnostics
{
public:
  /// Maps and topics must outlive this.
  PlannerDiagnostics(const Robot& robot, const MapStore& maps, const PlannerTopics& topics);

private:
  void report_map(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void report_plan(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  const std::string fingerprint_;  ///< of the robot
  const MapStore& maps_;
  const PlannerTopics& topics_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace fourwis
