#include "creep.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_traits.h"

namespace fourwis
{
namespace
{

constexpr double kAcceleration = 0.5;  ///< of a creeping motion [m/s^2]
constexpr double kShortest = 1e-3;     ///< of its parts [s]

/// Over the signed length; poses are `pose(s)` at arc length s.
template <class PoseAt>
Creep creep(Mode mode, double phi, double length, double speed, PoseAt pose)
{
  const double way = std::abs(length), top = std::min(speed, std::sqrt(way * kAcceleration));
  const double ramp = std::max(kShortest, top / kAcceleration);
  const double cruise = std::max(kShortest, way / std::max(top, kShortest) - ramp);
  const double v = std::copysign(way / (ramp + cruise), length);
  const double t[] = {0.0, ramp, ramp + cruise, 2.0 * ramp + cruise};
  const double s[] = {0.0, 0.5 * v * ramp, v * (0.5 * ramp + cruise), length};
  Creep points;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const Pose at = pose(s[k]);
    points[k] = {t[k], mode, at.x, at.y, at.theta, k == 1 || k == 2 ? v : 0.0, phi, 0.0, 0.0};
  }
  return points;
}

}  // namespace

Creep creeping_turn(const Robot& robot, const Pose& from, double angle, double speed)
{
  const double radius = spin_radius(robot);
  const auto turned = [&](double s) { return Pose{from.x, from.y, from.theta + s / radius}; };
  return creep(kTurnInPlace, 0.0, angle * radius, speed, turned);
}

Creep creeping_shift(const Pose& from, const Pose& to, double speed)
{
  const double direction = std::atan2(to.y - from.y, to.x - from.x);
  // There are two ways to set the wheels. The one that is nearer to straight ahead is taken.
  const double ahead = wrap_angle(direction - from.theta);
  const bool backward = std::abs(ahead) > M_PI_2;
  const double phi = backward ? wrap_angle(ahead + M_PI) : ahead, course = from.theta + phi;
  const double way = backward ? -distance(from, to) : distance(from, to);
  const auto shifted = [&](double s) {
    return Pose{from.x + s * std::cos(course), from.y + s * std::sin(course), from.theta};
  };
  return creep(kTranslation, phi, way, speed, shifted);
}

}  // namespace fourwis
