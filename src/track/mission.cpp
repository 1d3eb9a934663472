#include "mission.h"

#include <algorithm>

namespace fourwis
{

Mission mission_of(const Robot& robot, const Trajectory& trajectory)
{
  Mission mission;
  for (auto first = trajectory.begin(); first != trajectory.end();)
  {
    const auto end =
        std::find_if(first, trajectory.end(), [&](const TrajectoryPoint& point) { return point.mode != first->mode; });
    mission.emplace_back(robot, &*first, &*first + (end - first));
    first = end;
  }
  return mission;
}

}  // namespace fourwis
