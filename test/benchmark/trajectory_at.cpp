#include "trajectory_at.h"

#include <algorithm>
#include <cmath>

namespace fourwis::benchmark
{
namespace
{

/// Direction of travel in the body and yaw per metre.
std::pair<double, double> kinematics(const Robot& robot, Mode mode, double phi)
{
  if (mode == Mode::ackermann) return {0.0, 2.0 * std::tan(phi) / robot.wheelbase};
  if (mode == Mode::lateral) return {M_PI_2, 2.0 * std::tan(phi) / robot.track_width};
  return {phi, 0.0};
}

}  // namespace

TrajectoryPoint trajectory_at(const Robot& robot, const Trajectory& trajectory, double t)
{
  const auto next = std::upper_bound(trajectory.begin(), trajectory.end(), t,
                                     [](double time, const TrajectoryPoint& point) { return time < point.t; });
  if (next == trajectory.begin()) return trajectory.front();
  if (next == trajectory.end()) return trajectory.back();
  TrajectoryPoint p = *std::prev(next);
  if (next->mode != p.mode) return p;
  const double h = next->t - p.t, a = (next->v - p.v) / h, omega = (next->phi - p.phi) / h;
  constexpr int parts = 200;
  const double step = (t - p.t) / parts;
  for (int i = 0; i < parts; ++i)
  {
    p.v += 0.5 * step * a;
    p.phi += 0.5 * step * omega;
    const auto [course, yaw] = kinematics(robot, p.mode, p.phi);
    const double middle = p.theta + 0.5 * step * p.v * yaw;
    p.x += step * p.v * std::cos(middle + course);
    p.y += step * p.v * std::sin(middle + course);
    p.theta += step * p.v * yaw;
    p.v += 0.5 * step * a;
    p.phi += 0.5 * step * omega;
  }
  p.t = t;
  return p;
}

double driving_time(const Trajectory& trajectory)
{
  double time = 0.0;
  for (std::size_t k = 0; k + 1 < trajectory.size(); ++k)
    if (trajectory[k].mode == trajectory[k + 1].mode) time += trajectory[k + 1].t - trajectory[k].t;
  return time;
}

}  // namespace fourwis::benchmark
