#include "driven_body.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "../support/random.h"

namespace fourwis::nightly
{
namespace
{

constexpr double kSample = 0.005;                   ///< longest way of a point of the body between two samples [m]
constexpr double kGap = 0.005, kHeadingGap = 0.01;  ///< of a drive's end to the next point [m], [rad]

/// Velocity of C, the centre of the wheels, in the body frame [m/s] and yaw rate [rad/s].
using BodyVelocity = std::array<double, 3>;

BodyVelocity body_velocity(const Robot& robot, Mode mode, double v, double phi)
{
  switch (mode)
  {
    case Mode::ackermann: return {v, 0.0, 2.0 * v * std::tan(phi) / robot.wheelbase};
    case Mode::lateral: return {0.0, v, 2.0 * v * std::tan(phi) / robot.track_width};
    case Mode::parallel: return {v * std::cos(phi), v * std::sin(phi), 0.0};
    default: return {};
  }
}

/// Distance of the body's farthest corner from C [m].
double farthest_corner(const Robot& robot)
{
  if (robot.footprint.empty())
    return std::hypot(std::abs(robot.body_offset.x) + robot.length / 2.0,
                      std::abs(robot.body_offset.y) + robot.width / 2.0);
  double farthest = 0.0;
  for (const Point2& corner : robot.footprint)
    farthest = std::max(farthest, std::hypot(corner.x - robot.base_offset.x, corner.y - robot.base_offset.y));
  return farthest;
}

/// The drive from one point of a trajectory to the next: v and phi change linearly in time.
class Drive
{
public:
  Drive(const Robot& robot, const TrajectoryPoint& from, const TrajectoryPoint& to)
    : robot_(robot),
      from_(from),
      to_(to)
  {
    const double corner = farthest_corner(robot);
    double fastest = 0.0;
    for (const TrajectoryPoint* point : {&from, &to})
    {
      // The steepest phi with the greatest speed: an upper bound for all that is between.
      const double v = std::max(std::abs(from.v), std::abs(to.v));
      const BodyVelocity velocity = body_velocity(robot, from.mode, v, point->phi);
      fastest = std::max(fastest, v + corner * std::abs(velocity[2]));
    }
    samples_ = std::max(1, static_cast<int>(std::ceil(fastest * duration() / kSample)));
  }

  int samples() const { return samples_; }

  /// The pose after sample k, from that after sample k - 1: Runge and Kutta's step.
  Pose next(const Pose& pose, int k) const
  {
    const double h = duration() / samples_;
    const double begin = (k - 1.0) / samples_, middle = (k - 0.5) / samples_, end = static_cast<double>(k) / samples_;
    const Pose k1 = slope(pose.theta, begin);
    const Pose k2 = slope(pose.theta + h / 2.0 * k1.theta, middle);
    const Pose k3 = slope(pose.theta + h / 2.0 * k2.theta, middle);
    const Pose k4 = slope(pose.theta + h * k3.theta, end);
    const auto step = [&](double Pose::*part) {
      return h / 6.0 * (k1.*part + 2.0 * k2.*part + 2.0 * k3.*part + k4.*part);
    };
    return {pose.x + step(&Pose::x), pose.y + step(&Pose::y), pose.theta + step(&Pose::theta)};
  }

private:
  double duration() const { return to_.t - from_.t; }

  /// dx/dt, dy/dt and dtheta/dt at a heading, when a share of the time is over.
  Pose slope(double theta, double share) const
  {
    const double v = from_.v + share * (to_.v - from_.v), phi = from_.phi + share * (to_.phi - from_.phi);
    const auto [vx, vy, omega] = body_velocity(robot_, from_.mode, v, phi);
    return {vx * std::cos(theta) - vy * std::sin(theta), vx * std::sin(theta) + vy * std::cos(theta), omega};
  }

  const Robot& robot_;
  const TrajectoryPoint &from_, &to_;
  int samples_;
};

/// What a body may still overlap of the obstacles that it overlaps at the start.
class Overlap
{
public:
  Overlap(const ExactRectangle& body, double start_tolerance) : body_(body), greatest_(start_tolerance) {}

  /// To be asked pose by pose along the drive.
  bool is_forbidden(const Pose& pose)
  {
    const bool collides = body_.collides(pose);
    if (collides && !(body_.depth(pose) <= greatest_ + kRounding)) return true;
    greatest_ = collides ? std::min(greatest_, body_.depth(pose)) : -kRounding;
    return false;
  }

private:
  static constexpr double kRounding = 1e-6;  ///< of depths [m]

  const ExactRectangle& body_;
  double greatest_;
};

}  // namespace

std::string fault_in_drive(const Trajectory& trajectory, const Robot& robot,
                           const std::function<bool(const Pose&)>& is_forbidden)
{
  for (std::size_t i = 0; i < trajectory.size(); ++i)
  {
    if (is_forbidden(trajectory[i].pose())) return "collides at " + text(trajectory[i].pose());
    if (i + 1 == trajectory.size()) break;
    const TrajectoryPoint &from = trajectory[i], &to = trajectory[i + 1];
    Pose pose = from.pose();
    if (from.mode == to.mode)
    {
      const Drive drive(robot, from, to);
      for (int k = 1; k <= drive.samples(); ++k)
      {
        pose = drive.next(pose, k);
        if (is_forbidden(pose)) return "collides at " + text(pose) + " after point " + std::to_string(i);
      }
    }
    if (!(distance(pose, to.pose()) <= kGap) || !(std::abs(pose.theta - to.theta) <= kHeadingGap))
      return "the drive from point " + std::to_string(i) + " ends at " + text(pose) + ", not at " + text(to.pose());
  }
  return {};
}

std::string fault_in_drive(const Trajectory& trajectory, const Robot& robot, const ExactRectangle& body,
                           double start_tolerance)
{
  Overlap overlap(body, start_tolerance);
  return fault_in_drive(trajectory, robot, [&](const Pose& pose) { return overlap.is_forbidden(pose); });
}

}  // namespace fourwis::nightly
