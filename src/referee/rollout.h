#pragma once

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis::referee
{

/// The motion from one point towards the next of the same mode, by doc/design.md, "The meaning of a
/// trajectory". C is the centre of the four wheels, (x, y) its position. v and phi are linear in time, and
///   ackermann: course theta,          theta' = 2 v tan(phi) / L
///   lateral:   course theta + pi/2,   theta' = 2 v tan(phi) / W
///   parallel:  course theta + phi,    theta' = 0
/// with (x, y)' = v (cos course, sin course). Theta and then x, y are integrated by Simpson's rule in short steps.
class Rollout
{
public:
  Rollout(const Robot& robot, const TrajectoryPoint& from, const TrajectoryPoint& to);

  /// Goes on for a share of the time between the points.
  void advance(double share);

  double remaining() const { return std::max(0.0, 1.0 - elapsed_); }  ///< share of the time that is left

  double x() const { return x_; }
  double y() const { return y_; }
  double theta() const { return theta_; }
  double cosine() const { return heading_.c; }  ///< of theta
  double sine() const { return heading_.s; }

  /// Greatest speed |v| of C on what remains [m/s].
  double greatest_speed() const { return std::max(std::abs(speed(elapsed_)), std::abs(speed(1.0))); }
  /// Greatest |theta'| / |v| anywhere on the way [1/m].
  double greatest_curvature() const { return std::max(std::abs(curvature_), std::abs(last_curvature_)); }

private:
  struct Direction
  {
    double c, s;
  };

  // Time runs from 0 to 1 from point to point: shares cannot overflow, however close or far apart the points are.
  double speed(double share) const { return v_ + change_of_v_ * share; }
  double phi(double share) const { return phi_ + change_of_phi_ * share; }
  double curvature(double share) const { return held_ ? curvature_ : tangent_factor_ * std::tan(phi(share)); }
  Direction heading(double theta) const
  {
    return theta == theta_ ? heading_ : Direction{std::cos(theta), std::sin(theta)};
  }
  Direction course(Direction heading, double share) const;
  void step(double share);

  Mode mode_;
  double duration_;  ///< [s]
  double elapsed_ = 0.0;
  double x_, y_, theta_;
  double v_, change_of_v_;
  double phi_, change_of_phi_;
  bool held_;                          ///< phi does not change, or nothing turns with it
  double tangent_factor_ = 0.0;        ///< theta' = factor tan(phi) v
  double curvature_, last_curvature_;  ///< now and at the next point
  Direction heading_, course_;         ///< now
};

}  // namespace fourwis::referee
