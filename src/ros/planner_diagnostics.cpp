#include "planner_diagnostics.h"

#include "conversions.h"
#include "fourwis_navigation/model/fingerprint.h"

namespace fourwis
{

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;
using fourwis_navigation::PlannerStatus;

PlannerDiagnostics::PlannerDiagnostics(const Robot& robot, const MapStore& maps, const PlannerTopics& topics)
  : fingerprint_(fingerprint(robot)),
    maps_(maps),
    topics_(topics)
{
  updater_.setHardwareID("none");
  updater_.add("map", [this](DiagnosticStatusWrapper& status) { report_map(status); });
  updater_.add("plan", [this](DiagnosticStatusWrapper& status) { report_plan(status); });
  timer_ = ros::NodeHandle().createWallTimer(ros::WallDuration(0.1),
                                             [this](const ros::WallTimerEvent&) { updater_.update(); });
}

void PlannerDiagnostics::report_map(DiagnosticStatusWrapper& status) const
{
  const MapStore::Snapshot map = maps_.newest();
  if (!map)
  {
    status.summary(DiagnosticStatus::WARN, "no usable map received yet");
    return;
  }
  const OccupancyGrid& grid = map->world.grid;
  status.summary(DiagnosticStatus::OK, "map received");
  status.add("width [cells]", grid.width);
  status.add("height [cells]", grid.height);
  status.add("resolution [m]", grid.resolution);
  status.add("stamp [s]", map->stamp.toSec());
  status.add("build [ms]", map->world.build_ms);
}

void PlannerDiagnostics::report_plan(DiagnosticStatusWrapper& status) const
{
  const PlannerStatus last = topics_.last_status();
  status.summary(last.state == PlannerStatus::FAILED ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
                 last.status + ": " + last.message);
  status.add("fingerprint of the robot", fingerprint_);
  status.add("expansions", last.metrics.expansions);
  status.add("total [ms]", last.metrics.total_ms);
}

}  // namespace fourwis
