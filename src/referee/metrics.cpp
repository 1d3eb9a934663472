#include "fourwis_navigation/referee/metrics.h"

#include <algorithm>
#include <cmath>

namespace fourwis
{
namespace
{

constexpr double kStandardDeviation = 0.15;  ///< eta of paper eq. (30)
constexpr double kStandstill = 0.01;         ///< epsilon_v of paper eq. (30), which gives no value [m/s]
constexpr double kLeastChord = 1e-6;         ///< closer points have no curvature [m]

double chord(const TrajectoryPoint& a, const TrajectoryPoint& b)
{
  return std::hypot(b.x - a.x, b.y - a.y);
}

/// Curvature of the circle through three points, paper eq. (27) [1/m].
double three_point_curvature(const TrajectoryPoint& a, const TrajectoryPoint& b, const TrajectoryPoint& c)
{
  const double cross = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
  return 2.0 * std::abs(cross) / (chord(a, b) * chord(b, c) * chord(a, c));
}

bool one_motion(const TrajectoryPoint& a, const TrajectoryPoint& b, const TrajectoryPoint& c)
{
  return a.mode == b.mode && b.mode == c.mode && a.v * b.v >= 0.0 && b.v * c.v >= 0.0 &&
         (a.v + b.v) * (b.v + c.v) > 0.0 && chord(a, b) > kLeastChord && chord(b, c) > kLeastChord &&
         chord(a, c) > kLeastChord;
}

/// Whether the motion between two points is one of the standard ones, paper eq. (28) to (30).
bool is_standard(const TrajectoryPoint& a, const TrajectoryPoint& b, double radius)
{
  const double dt = b.t - a.t, heading = (a.theta + b.theta) / 2.0;
  const double dx = (b.x - a.x) / dt, dy = (b.y - a.y) / dt, spin = std::abs(b.theta - a.theta) / dt * radius;
  const double forward = std::abs(std::cos(heading) * dx + std::sin(heading) * dy);
  const double sideways = std::abs(-std::sin(heading) * dx + std::cos(heading) * dy);
  const double speed = std::hypot(dx, dy), q = std::max(speed, spin);
  if (speed < kStandstill && spin < kStandstill) return true;
  return std::min({spin, sideways, forward, speed}) / q < kStandardDeviation;
}

}  // namespace

void measure(const Trajectory& trajectory, const Robot& robot, PlanMetrics& metrics)
{
  const double radius = std::hypot(robot.wheelbase, robot.track_width) / 2.0;
  double curvature_sum = 0.0;
  int curvatures = 0, standard = 0, steps = 0;
  for (std::size_t i = 1; i < trajectory.size(); ++i)
  {
    const TrajectoryPoint &a = trajectory[i - 1], &b = trajectory[i];
    metrics.length += chord(a, b);
    metrics.switches += a.mode != b.mode;
    standard += is_standard(a, b, radius);
    ++steps;
    if (i + 1 == trajectory.size() || !one_motion(a, b, trajectory[i + 1])) continue;
    const double kappa = three_point_curvature(a, b, trajectory[i + 1]);
    curvature_sum += kappa;
    metrics.max_curvature = std::max(metrics.max_curvature, kappa);
    ++curvatures;
  }
  metrics.arrival_time = trajectory.empty() ? 0.0 : trajectory.back().t;
  metrics.mean_curvature = curvatures > 0 ? curvature_sum / curvatures : 0.0;
  metrics.standard_mode_rate = steps > 0 ? static_cast<double>(standard) / steps : 1.0;
}

}  // namespace fourwis
