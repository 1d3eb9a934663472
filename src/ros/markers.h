#pragma once

#include <vector>

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{

/// What rviz shows of a plan: path and footprints coloured by mode (ackermann blue, lateral orange, parallel green),
/// start (grey), goal (red) and the places where the modes switch (magenta). Always the same namespaces and ids, so
/// that a plan replaces the one before it.
visualization_msgs::MarkerArray plan_markers(const Robot& robot, const PlanRequest& request,
                                             const Trajectory& trajectory, const std_msgs::Header& header);

/// The status of a plan that failed, written at its goal; plan_markers() removes it.
visualization_msgs::Marker failure_marker(const Pose& goal, PlanStatus status, const std_msgs::Header& header);

/// The regions of the discs' centres as translucent triangles. `around` is a point of the plan: what is farther away
/// than any plan goes is cut off.
visualization_msgs::Marker corridor_marker(const std::vector<Corridor>& corridors, const Pose& around,
                                           const std_msgs::Header& header);

/// What the rounds of the optimisation made of the path before the last one, as thin lines, the later the more opaque.
visualization_msgs::Marker iteration_marker(const std::vector<Trajectory>& iterations, const std_msgs::Header& header);

/// The nodes that the search expanded, as points.
visualization_msgs::Marker expansion_marker(const PlanTrace& trace, const std_msgs::Header& header);

}  // namespace fourwis
