#pragma once

#include <cmath>

namespace fourwis
{

/// A planar pose in the map frame: x, y in metres, theta in radians, counter-clockwise (REP-103).
struct Pose
{
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;
};

/// The same angle in (-pi, pi].
inline double wrap_angle(double angle)
{
  const double wrapped = std::remainder(angle, 2.0 * M_PI);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

/// Distance between the positions of two poses [m].
inline double distance(const Pose& a, const Pose& b)
{
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// `pose`, given in the frame of `base`, expressed in the frame `base` is given in.
inline Pose compose(const Pose& base, const Pose& pose)
{
  const double c = std::cos(base.theta), s = std::sin(base.theta);
  return {base.x + c * pose.x - s * pose.y, base.y + s * pose.x + c * pose.y, base.theta + pose.theta};
}

/// `pose` expressed in the frame of `base`: compose(base, relative_to(base, pose)) == pose.
inline Pose relative_to(const Pose& base, const Pose& pose)
{
  const double c = std::cos(base.theta), s = std::sin(base.theta);
  const double dx = pose.x - base.x, dy = pose.y - base.y;
  return {c * dx + s * dy, -s * dx + c * dy, pose.theta - base.theta};
}

inline bool is_finite(const Pose& pose)
{
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.theta);
}

}  // namespace fourwis
