#include "fourwis_navigation/map/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

/// Shortest stride along a motion where the safety margin is small or zero [m].
constexpr double kLeastStride = 0.01;
/// More clearance than this is not asked for [m].
constexpr double kFarClearance = 1.0;

/// Greatest curvature of a disc centre's path in any mode [1/m]; infinite where the robot may turn about the centre.
double greatest_disc_curvature(const Robot& robot, double offset)
{
  // In Ackermann motion C's path is beside both discs' and bends more; in lateral motion they lie in line with the turning centre.
  const double ackermann = max_curvature(robot, Mode::ackermann), lateral = max_curvature(robot, Mode::lateral);
  const double from_centre = 1.0 / lateral - offset;
  return from_centre > 0.0 ? std::max(ackermann, 1.0 / from_centre) : std::numeric_limits<double>::infinity();
}

/// Along a path of curvature up to k, the square of the distance f to a point has the second derivative 2 (1 + k f) at
/// most. Where it is r at both ends and less between them, it is therefore at least r^2 - (1 + k r) s^2 / 4 if the ends
/// are s apart, and r - s / 2 whatever the curvature.
double clearance_between_checks(double radius, double curvature, double stride)
{
  const double squared = radius * radius - (1.0 + curvature * radius) * stride * stride / 4.0;
  return std::max(radius - stride / 2.0, std::sqrt(std::max(0.0, squared)));
}

}  // namespace

CollisionChecker::CollisionChecker(const ObstacleMap& map, const Robot& robot)
  : map_(map), robot_(robot), discs_(two_discs(robot)), stride_(std::max(kLeastStride, robot.safety_margin)),
    least_clearance_(clearance_between_checks(discs_.radius, greatest_disc_curvature(robot, discs_.offset), stride_))
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
