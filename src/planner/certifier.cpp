#include "certifier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

/// Greatest motion between two checked poses where an obstacle is touched [m].
constexpr double kLeastStep = 0.002;
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

Certifier::Certifier(const ObstacleMap& map, const Robot& robot, std::vector<DiscCover> covers)
  : map_(map),
    robot_(robot),
    covers_(std::move(covers))
{}

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
  const double speed = std::max(greatest_disc_speed(from, to), 1e-6);
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
double Certifier::greatest_disc_speed(const TrajectoryPoint& from, const TrajectoryPoint& to) const
{
  double reach = 0.0;
  for (const DiscCover& discs : covers_) reach = std::max(reach, discs.reach());
  const double kappa =
      std::max(std::abs(curvature(robot_, from.mode, from.phi)), std::abs(curvature(robot_, from.mode, to.phi)));
  return std::max(std::abs(from.v), std::abs(to.v)) * (1.0 + kappa * reach);
}

/// Least distance to obstacles of the cover that is clearest [m]. If the first cover is clear, the others are not
/// checked.
double Certifier::clearance_at(const State& x) const
{
  double clearance = -std::numeric_limits<double>::infinity();
  for (const DiscCover& discs : covers_)
    if (clearance < kLeastStep) clearance = std::max(clearance, cover_clearance(map_, discs, x));
  return clearance;
}

}  // namespace fourwis
