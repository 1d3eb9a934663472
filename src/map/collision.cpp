#include "fourwis_navigation/map/collision.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

/// Shortest stride along a motion where the safety margin is small or zero [m].
constexpr double kLeastStride = 0.01;
/// More clearance than this is not asked for [m].
constexpr double kFarClearance = 1.0;

/// What is left of the clearance r = `radius` of a disc centre between two poses at which it has that much. C turns about a
/// point R = `turning_radius` or more away, the disc centre about the same point q <= R + o away, and it moves
/// s q / (R + o) at most: strides are measured on the disc farther out. Along a path of curvature 1 / q the square of the
/// distance f to an obstacle has the second derivative 2 (1 + f / q) at most. Where f is r at both ends and less between
/// them, f^2 is therefore no less than r^2 - (1 + r / q) (s q / (R + o))^2 / 4 >= r^2 - (1 + r / (R + o)) s^2 / 4.
double clearance_between_checks(double radius, double offset, double turning_radius, double stride)
{
  const double squared = radius * radius - (1.0 + radius / (turning_radius + offset)) * stride * stride / 4.0;
  return std::max(radius - stride / 2.0, std::sqrt(std::max(0.0, squared)));
}

double least_turning_radius(const Robot& robot)
{
  return 1.0 / std::max(max_curvature(robot, Mode::ackermann), max_curvature(robot, Mode::lateral));
}

}  // namespace

CollisionChecker::CollisionChecker(const ObstacleMap& map, const Robot& robot)
  : map_(map), robot_(robot), discs_(two_discs(robot)), stride_(std::max(kLeastStride, robot.safety_margin)),
    least_clearance_(clearance_between_checks(discs_.radius, discs_.offset, least_turning_radius(robot), stride_))
{
}

bool CollisionChecker::is_free(double x, double y, double cosine, double sine, double& clearance) const
{
  const double ox = discs_.offset * cosine, oy = discs_.offset * sine;
  return map_.is_clear(x + ox, y + oy, discs_.radius, clearance) && map_.is_clear(x - ox, y - oy, discs_.radius, clearance);
}

bool CollisionChecker::is_free(const Pose& pose) const
{
  double clearance = 0.0;
  return is_free(pose.x, pose.y, std::cos(pose.theta), std::sin(pose.theta), clearance);
}

double CollisionChecker::free_length(const PathPiece& piece) const
{
  const double total = std::abs(piece.length), direction = piece.length < 0.0 ? -1.0 : 1.0;
  const Arc arc(robot_, piece.start, piece.mode, piece.phi);
  // A disc centre moves at most this much for each metre that C does.
  const double stretch = 1.0 + std::abs(arc.curvature()) * discs_.offset;
  double free = 0.0;
  for (double s = 0.0;;)
  {
    const Arc::Placement placement = arc.at(direction * s);
    double clearance = kFarClearance;
    if (!is_free(placement.x, placement.y, placement.cosine, placement.sine, clearance)) return free;
    free = s;
    if (s >= total) return total;
    s = std::min(total, s + std::max(stride_, clearance) / stretch);
  }
}

}  // namespace fourwis
