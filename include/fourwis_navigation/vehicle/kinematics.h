#pragma once

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Velocity of the body in its own frame: vx, vy [m/s], omega [rad/s].
struct Twist
{
  double vx = 0.0, vy = 0.0, omega = 0.0;
};

/// Body twist of a mode at speed v and equivalent steering angle phi, paper eq. (5) to (7). In spin v is the rolling
/// speed of each wheel, > 0 to the left, and phi means nothing. Zero for Mode::none.
Twist body_twist(const Robot& robot, Mode mode, double v, double phi);

/// Distance of the steering axes from C, the centre of the wheels [m]: in spin omega = v / spin_radius.
double spin_radius(const Robot& robot);

/// omega / v of a mode at equivalent steering angle phi [1/m]: 2 tan(phi)/L, 2 tan(phi)/W, 0, in spin 1/spin_radius.
double curvature(const Robot& robot, Mode mode, double phi);

/// d curvature / d phi [1/m].
double curvature_slope(const Robot& robot, Mode mode, double phi);

/// Greatest curvature of a mode [1/m], first two rows of paper eq. (14); 0 in parallel mode.
double max_curvature(const Robot& robot, Mode mode);

/// Distance of C from the point about which the body turns [m]: infinite in a straight motion, 0 where C does not move.
double turning_radius(const Robot& robot, Mode mode, double phi);

/// Direction in which C moves for v > 0, relative to the heading [rad]: 0, pi/2, phi. 0 where C does not move.
double course(Mode mode, double phi);

/// The curve C follows while phi is held: a circular arc or a straight line, in spin a point.
class Arc
{
public:
  Arc(const Robot& robot, const Pose& start, Mode mode, double phi);

  /// A pose with the cosine and sine of its heading, which are needed to compute points of the body.
  struct Placement
  {
    double x, y, cosine, sine;
  };

  /// Where the robot is at signed arc length s [m], in spin that of the wheels.
  Placement at(double s) const;

  /// The same as a pose; theta is not wrapped.
  Pose pose(double s) const;

  double curvature() const { return kappa_; }

private:
  Pose start_;
  double kappa_;
  double cos_, sin_;                ///< of the heading at the start
  double cos_course_, sin_course_;  ///< of the direction of travel at the start; 0 where C does not move
};

/// Where the robot is after driving the signed arc length s [m] from `start` with phi held: the exact arc. theta is not
/// wrapped.
Pose advance(const Robot& robot, const Pose& start, Mode mode, double phi, double s);

/// Where a body is after it has kept the twist for `duration` [s]: the exact arc, the exponential of SE(2). theta is
/// not wrapped.
Pose move(const Pose& start, const Twist& twist, double duration);

}  // namespace fourwis
