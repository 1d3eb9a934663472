#pragma once

#include <cmath>
#include <string>

#include "fourwis_navigation/referee/referee.h"

namespace fourwis
{

/// Makes trajectories for the tests of the referee, one interval after the other, with an integration of its own: the
/// midpoint rule in very short steps.
class Script
{
public:
  Script(const Pose& start, Mode mode, double phi = 0.0, const Robot& robot = {}) : robot_(robot)
  {
    TrajectoryPoint point;
    point.mode = mode;
    point.x = start.x, point.y = start.y, point.theta = start.theta;
    point.phi = phi;
    points_.push_back(point);
  }

  /// v and phi change linearly for `duration`.
  Script& go(double duration, double v, double phi)
  {
    TrajectoryPoint& from = points_.back();
    from.a = (v - from.v) / duration;
    from.omega = (phi - from.phi) / duration;
    TrajectoryPoint to = from;
    constexpr int kSteps = 4000;
    for (int k = 0; k < kSteps; ++k)
    {
      const double share = (k + 0.5) / kSteps, h = duration / kSteps;
      midpoint(to, from.v + share * (v - from.v), from.phi + share * (phi - from.phi), h);
    }
    to.t = from.t + duration;
    to.v = v, to.phi = phi, to.a = 0.0, to.omega = 0.0;
    points_.push_back(to);
    return *this;
  }

  /// Accelerates from rest to speed v, keeps it for `duration`, and brakes to rest, with constant phi.
  Script& drive(double v, double duration, double acceleration = 4.0)
  {
    const double phi = points_.back().phi, ramp = std::abs(v) / acceleration;
    return go(ramp, v, phi).go(duration, v, phi).go(ramp, 0.0, phi);
  }

  Script& switch_to(Mode mode, double phi, double duration)
  {
    TrajectoryPoint to = points_.back();
    to.t += duration;
    to.mode = mode;
    to.phi = phi;
    points_.push_back(to);
    return *this;
  }

  const Trajectory& points() const { return points_; }
  Pose start() const { return points_.front().pose(); }
  Pose end() const { return points_.back().pose(); }

private:
  void midpoint(TrajectoryPoint& p, double v, double phi, double h) const
  {
    double turn = 0.0, course = 0.0;
    if (p.mode == Mode::ackermann) turn = 2.0 * v * std::tan(phi) / robot_.wheelbase;
    if (p.mode == Mode::lateral) turn = 2.0 * v * std::tan(phi) / robot_.track_width, course = M_PI_2;
    if (p.mode == Mode::parallel) course = phi;
    const double direction = p.theta + h / 2.0 * turn + course;
    p.x += h * v * std::cos(direction);
    p.y += h * v * std::sin(direction);
    p.theta += h * turn;
  }

  Robot robot_;
  Trajectory points_;
};

/// All sentences of a verdict, for failure messages.
inline std::string sentences(const Verdict& verdict)
{
  std::string all;
  for (const Violation& violation : verdict.violations)
    all += "point " + std::to_string(violation.point) + ": " + violation.what + "\n";
  return all;
}

inline bool complains_of(const Verdict& verdict, const std::string& what)
{
  return sentences(verdict).find(what) != std::string::npos;
}

}  // namespace fourwis
