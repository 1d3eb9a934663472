#include "stop_and_steer.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_limits.h"
#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

/// Greatest time between two points while driving [s].
constexpr double kPointInterval = 0.1;
/// Shortest stop that changes anything [s].
constexpr double kLeastWait = 1e-3;
/// Samples of a wheel's angle while the equivalent angle turns at a constant rate.
constexpr int kSteeringSamples = 32;

/// Neighbouring pieces driven with one steering angle in one direction are one stretch.
std::vector<PathPiece> merge(const std::vector<PathPiece>& pieces)
{
  std::vector<PathPiece> stretches;
  for (const PathPiece& piece : pieces)
  {
    if (!stretches.empty())
    {
      PathPiece& last = stretches.back();
      if (last.mode == piece.mode && last.phi == piece.phi && std::signbit(last.length) == std::signbit(piece.length))
      {
        last.length += piece.length;
        continue;
      }
    }
    stretches.push_back(piece);
  }
  return stretches;
}

class Timeline
{
public:
  explicit Timeline(const Robot& robot) : robot_(robot) {}

  void stand(const PathPiece& stretch, double duration)
  {
    if (points_.empty()) return;
    TrajectoryPoint& last = points_.back();
    if (last.mode == stretch.mode && duration > 0.0) last.omega = (stretch.phi - last.phi) / duration;
    time_ += duration;
  }

  /// From rest to rest along a stretch: accelerate, cruise, brake.
  void drive(const PathPiece& stretch)
  {
    const double length = std::abs(stretch.length), a = robot_.max_acceleration;
    const double limit = greatest_speed(robot_, stretch.mode, stretch.phi);
    const double peak = std::min(limit, std::sqrt(a * length));
    const double ramp = peak / a, cruise = std::max(0.0, length / peak - ramp);
    if (points_.empty() || points_.back().mode != stretch.mode || points_.back().phi != stretch.phi)
      add(stretch, 0.0, 0.0, 0.0);
    phase(stretch, 0.0, 0.0, a, ramp);
    phase(stretch, peak * ramp / 2.0, peak, 0.0, cruise);
    phase(stretch, peak * ramp / 2.0 + peak * cruise, peak, -a, ramp);
    TrajectoryPoint& end = points_.back();
    const Pose pose = advance(robot_, stretch.start, stretch.mode, stretch.phi, stretch.length);
    end.x = pose.x;
    end.y = pose.y;
    end.theta = pose.theta;
    end.v = end.a = 0.0;
  }

  Trajectory take() { return std::move(points_); }

private:
  /// Constant acceleration for `duration`, beginning at arc length s and speed v of the stretch.
  void phase(const PathPiece& stretch, double s, double v, double a, double duration)
  {
    if (duration <= 1e-12) return;
    const double sign = stretch.length < 0.0 ? -1.0 : 1.0, begin = time_;
    points_.back().a = a == 0.0 ? 0.0 : sign * a;
    const int steps = static_cast<int>(std::ceil(duration / kPointInterval));
    for (int k = 1; k <= steps; ++k)
    {
      const double t = duration * k / steps;
      time_ = begin + t;
      add(stretch, sign * (s + v * t + a * t * t / 2.0), sign * (v + a * t), a == 0.0 ? 0.0 : sign * a);
    }
  }

  void add(const PathPiece& stretch, double s, double v, double a)
  {
    const Pose pose = advance(robot_, stretch.start, stretch.mode, stretch.phi, s);
    points_.push_back({time_, stretch.mode, pose.x, pose.y, pose.theta, v, stretch.phi, a, 0.0});
  }

  const Robot& robot_;
  double time_ = 0.0;
  Trajectory points_;
};

}  // namespace

double steering_time(const Robot& robot, Mode mode, double from, double to)
{
  WheelAngles last = wheel_angles(robot, mode, from);
  double time = std::max(std::abs(to - from) / robot.max_steering_rate,
                         reorientation_time(robot, last, wheel_angles(robot, mode, to)));
  Robot unlimited = robot;
  unlimited.wheel_max_angle = 2.0 * M_PI;
  for (int k = 1; k <= kSteeringSamples; ++k)
  {
    const WheelAngles next = wheel_angles(robot, mode, from + (to - from) * k / kSteeringSamples);
    time = std::max(time, kSteeringSamples * reorientation_time(unlimited, last, next));
    last = next;
  }
  // Between samples a wheel may turn a little faster; and two points never share one time.
  return std::max(kLeastWait, time * (1.0 + 1.0 / kSteeringSamples));
}

Trajectory stop_and_steer(const Path& path, const Robot& robot)
{
  Timeline timeline(robot);
  const PathPiece* last = nullptr;
  const std::vector<PathPiece> stretches = merge(path.pieces);
  for (const PathPiece& stretch : stretches)
  {
    if (last && last->mode != stretch.mode)
      timeline.stand(stretch, std::max(robot.mode_switch_time,
                                       reorientation_time(robot, wheel_angles(robot, last->mode, last->phi),
                                                          wheel_angles(robot, stretch.mode, stretch.phi))));
    else if (last && last->phi != stretch.phi)
      timeline.stand(stretch, steering_time(robot, stretch.mode, last->phi, stretch.phi));
    timeline.drive(stretch);
    last = &stretch;
  }
  return timeline.take();
}

}  // namespace fourwis
