#include "certifier.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fourwis_navigation/map/body_overlap.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

/// Greatest motion between two checked poses where an obstacle is touched [m].
constexpr double kLeastStep = 0.002;
/// Clearances of the body that are told apart [m].
constexpr std::array<double, 4> kMargins = {0.01, 0.004, 0.002, 0.001};
/// Clearances greater than this count as equal [m].
constexpr double kFar = 0.1;
/// Parts of an interval whose sum stands for the exact motion.
constexpr int kParts = 8;

using State = SimpsonDynamics::State;
using Control = SimpsonDynamics::Control;

State state_of(const TrajectoryPoint& p)
{
  State x;
  x << p.x, p.y, p.theta, p.v, p.phi;
  return x;
}

State after(const SimpsonDynamics& dynamics, const TrajectoryPoint& p, double t)
{
  return dynamics.next(state_of(p), Control(p.a, p.omega, t));
}

/// How far the exact motion from one point misses the next [m].
double rollout_miss(const SimpsonDynamics& dynamics, const TrajectoryPoint& from, const TrajectoryPoint& to)
{
  State x = state_of(from);
  for (int i = 0; i < kParts; ++i) x = dynamics.next(x, Control(from.a, from.omega, (to.t - from.t) / kParts));
  return std::hypot(x[0] - to.x, x[1] - to.y);
}

/// Least distance of the discs at a pose to obstacles, as far as it matters [m].
double cover_clearance(const ObstacleMap& map, const DiscCover& discs, const State& x)
{
  const double c = std::cos(x[2]), s = std::sin(x[2]);
  double clearance = 10.0 * kFar;
  for (const Point2& centre : discs.centres)
  {
    const double cx = x[0] + centre.x * c - centre.y * s, cy = x[1] + centre.x * s + centre.y * c;
    if (!map.is_clear(cx, cy, discs.radius, clearance))
      clearance = std::min(clearance, map.distance(cx, cy) - discs.radius);
  }
  return clearance;
}

}  // namespace

Certifier::Certifier(const ObstacleMap& map, const Robot& robot, const DiscCover& discs)
  : map_(map),
    robot_(robot),
    discs_(discs),
    reach_(discs.reach())
{
  const ConvexPolygon body = body_of(robot);
  for (double margin : kMargins) bodies_.push_back({margin, grown(body, margin)});
  reach_ = std::max(reach_, reach_of(bodies_.front().outline));
}

Certificate Certifier::certify(const Trajectory& points) const
{
  Certificate certificate;
  if (points.empty()) return certificate;
  const SimpsonDynamics dynamics(robot_, points.front().mode);
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
  {
    certificate.clearance.push_back(least_clearance(dynamics, points[k], points[k + 1]));
    certificate.worst_rollout = std::max(certificate.worst_rollout, rollout_miss(dynamics, points[k], points[k + 1]));
  }
  return certificate;
}

double Certifier::least_clearance(const SimpsonDynamics& dynamics, const TrajectoryPoint& from,
                                  const TrajectoryPoint& to) const
{
  const double duration = to.t - from.t;
  const double speed = std::max(greatest_speed_of_body(from, to), 1e-6);
  double least = kFar;
  for (double t = 0.0;;)
  {
    const double clearance = clearance_at(after(dynamics, from, t));
    least = std::min(least, clearance);
    if (t >= duration) return least;
    t = std::min(duration, t + std::max(clearance, kLeastStep) / speed);
  }
}

/// Greatest speed of a disc centre within an interval, whose v and phi are greatest at an end [m/s].
double Certifier::greatest_speed_of_body(const TrajectoryPoint& from, const TrajectoryPoint& to) const
{
  const double kappa =
      std::max(std::abs(curvature(robot_, from.mode, from.phi)), std::abs(curvature(robot_, from.mode, to.phi)));
  return std::max(std::abs(from.v), std::abs(to.v)) * (1.0 + kappa * reach_);
}

/// Least distance of the discs to obstacles, or where the body has more, that [m].
double Certifier::clearance_at(const State& x) const
{
  const double clearance = cover_clearance(map_, discs_, x);
  if (clearance >= kMargins.front()) return clearance;
  const Placed place = placed({x[0], x[1], x[2]});
  for (const GrownBody& body : bodies_)
    if (body.margin > clearance && is_clear(map_, body.outline, place)) return body.margin;
  return clearance;
}

}  // namespace fourwis
