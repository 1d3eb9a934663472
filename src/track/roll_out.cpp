#include "roll_out.h"

#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

/// Velocity in the frame of the pose, at heading theta.
Pose velocity(const Robot& robot, Mode mode, double theta, double v, double phi)
{
  const Twist twist = body_twist(robot, mode, v, phi);
  const double c = std::cos(theta), s = std::sin(theta);
  return {c * twist.vx - s * twist.vy, s * twist.vx + c * twist.vy, twist.omega};
}

}  // namespace

MotionState roll_out(const Robot& robot, Mode mode, const MotionState& start, const MotionInput& input, double duration)
{
  const auto at = [&](double fraction, double theta) {
    const double t = fraction * duration;
    return velocity(robot, mode, theta, start.v + t * input.a, start.phi + t * input.omega);
  };
  // The velocity depends on the pose only through theta, and the rate of theta does not depend on the pose. So theta is
  // integrated first, by Simpson's rule, up to the middle and to the end.
  const double theta = start.pose.theta;
  const double w0 = at(0.0, 0.0).theta, w1 = at(0.5, 0.0).theta, w2 = at(1.0, 0.0).theta;
  const double middle = theta + duration / 24.0 * (5.0 * w0 + 8.0 * w1 - w2);
  const double end = theta + duration / 6.0 * (w0 + 4.0 * w1 + w2);
  const Pose k0 = at(0.0, theta), k1 = at(0.5, middle), k2 = at(1.0, end);
  MotionState next = start;
  next.pose.x += duration / 6.0 * (k0.x + 4.0 * k1.x + k2.x);
  next.pose.y += duration / 6.0 * (k0.y + 4.0 * k1.y + k2.y);
  next.pose.theta = end;
  next.v += duration * input.a;
  next.phi += duration * input.omega;
  return next;
}

}  // namespace fourwis
