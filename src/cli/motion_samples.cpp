#include "motion_samples.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

/// More would only be thicker ink.
constexpr double kMaxStepsPerInterval = 1000.0;

/// Appends the poses between `a` and `b`, both excluded. v and phi vary linearly; midpoint rule.
void sample_interval(const Robot& robot, const TrajectoryPoint& a, const TrajectoryPoint& b, double step,
                     std::vector<Pose>& poses)
{
  const double duration = b.t - a.t;
  const double travel = std::max(std::abs(a.v), std::abs(b.v)) * duration;
  const double steps = std::ceil(std::clamp(travel / step, 1.0, kMaxStepsPerInterval));
  const double h = duration / steps;
  Pose pose = a.pose();
  for (double i = 0.5; i < steps - 1.0; ++i)
  {
    const double s = i / steps;
    const Twist twist = body_twist(robot, a.mode, a.v + s * (b.v - a.v), a.phi + s * (b.phi - a.phi));
    const double middle = pose.theta + twist.omega * h / 2.0;
    pose.x += h * (twist.vx * std::cos(middle) - twist.vy * std::sin(middle));
    pose.y += h * (twist.vx * std::sin(middle) + twist.vy * std::cos(middle));
    pose.theta += h * twist.omega;
    poses.push_back(pose);
  }
}

bool is_drawable(const TrajectoryPoint& point)
{
  return is_finite(point.pose()) && std::isfinite(point.t) && std::isfinite(point.v) && std::isfinite(point.phi);
}

}  // namespace

std::vector<ModeRun> sample_motion(const Robot& robot, const Trajectory& trajectory, double step)
{
  std::vector<ModeRun> runs;
  const TrajectoryPoint* previous = nullptr;
  for (const TrajectoryPoint& point : trajectory)
  {
    if (!is_drawable(point)) continue;
    if (!previous || previous->mode != point.mode)
      runs.push_back({point.mode, {}});
    else if (previous->t < point.t)
      sample_interval(robot, *previous, point, step, runs.back().poses);
    runs.back().poses.push_back(point.pose());
    previous = &point;
  }
  return runs;
}

std::vector<Pose> thin_out(const std::vector<Pose>& poses, double least_distance, double least_angle)
{
  std::vector<Pose> chosen;
  for (const Pose& pose : poses)
    if (chosen.empty() || distance(chosen.back(), pose) >= least_distance ||
        std::abs(pose.theta - chosen.back().theta) >= least_angle)
      chosen.push_back(pose);
  if (!poses.empty()) chosen.push_back(poses.back());
  return chosen;
}

}  // namespace fourwis
