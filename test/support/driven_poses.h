#pragma once

#include <cmath>
#include <vector>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// Poses along a trajectory, by an integration of its own: the midpoint rule. No point of the body moves more than about
/// `step` metres from one to the next.
inline std::vector<Pose> driven_poses(const Robot& robot, const Trajectory& points, double step = 0.002)
{
  std::vector<Pose> poses;
  const double reach = std::hypot(robot.length, robot.width) / 2.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    poses.push_back(points[i].pose());
    if (i + 1 == points.size() || points[i].mode != points[i + 1].mode) continue;
    const TrajectoryPoint &from = points[i], &to = points[i + 1];
    const double base = from.mode == Mode::lateral ? robot.track_width : robot.wheelbase;
    const auto turn_at = [&](double v, double phi) {
      return from.mode == Mode::parallel ? 0.0 : 2.0 * v * std::tan(phi) / base;
    };
    const double fastest = std::max(std::abs(from.v), std::abs(to.v));
    const double steepest = std::max(std::abs(from.phi), std::abs(to.phi));
    const double length = (to.t - from.t) * (fastest + reach * std::abs(turn_at(fastest, steepest)));
    const int parts = 1 + static_cast<int>(length / step);
    Pose at = from.pose();
    for (int k = 0; k < parts; ++k)
    {
      const double share = (k + 0.5) / parts, h = (to.t - from.t) / parts;
      const double v = from.v + share * (to.v - from.v), phi = from.phi + share * (to.phi - from.phi);
      const double turn = turn_at(v, phi);
      const double course = from.mode == Mode::lateral ? M_PI_2 : from.mode == Mode::parallel ? phi : 0.0;
      at.x += h * v * std::cos(at.theta + h / 2.0 * turn + course);
      at.y += h * v * std::sin(at.theta + h / 2.0 * turn + course);
      at.theta += h * turn;
      poses.push_back(at);
    }
  }
  return poses;
}

}  // namespace fourwis
