#include "fourwis_navigation/map/collision.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

/// Shortest stride along a motion where the safety margin is small or zero [m].
constexpr double kLeastStride = 0.01;
/// How far around a tight pose less than the safety margin is kept [m].
constexpr double kTightSpot = 1.0;
/// So that a pose has the margin that was measured at it [m].
constexpr double kRounding = 1e-6;
/// More clearance than this is not asked for [m].
constexpr double kFarClearance = 1.0;

/// What is left of the clearance r = `radius` of a disc centre between two poses at which it has that much. C, the
/// centre of the wheels, turns about a point R = `turning_radius` or more away, the disc centre about the same point q
/// <= R + o away, and it moves s q / (R + o) at most: strides are measured on the disc farther out. Along a path of
/// curvature 1 / q the square of the distance f to an obstacle has the second derivative 2 (1 + f / q) at most. Where f
/// is r at both ends and less between them, f^2 is therefore no less than r^2 - (1 + r / q) (s q / (R + o))^2 / 4 >=
/// r^2 - (1 + r / (R + o)) s^2 / 4.
double clearance_between_checks(double radius, double offset, double turning_radius, double stride)
{
  const double squared = radius * radius - (1.0 + radius / (turning_radius + offset)) * stride * stride / 4.0;
  return std::max(radius - stride / 2.0, std::sqrt(std::max(0.0, squared)));
}

double least_turning_radius(const Robot& robot)
{
  double least = std::numeric_limits<double>::infinity();
  for (Mode mode : kPlannedModes) least = std::min(least, turning_radius(robot, mode, robot.max_steering_angle));
  return least;
}

}  // namespace

CollisionChecker::CollisionChecker(const ObstacleMap& map, const Robot& robot)
  : map_(map),
    robot_(checked(robot)),
    discs_(two_discs(robot)),
    needed_(discs_),
    stride_(std::max(kLeastStride, robot.safety_margin)),
    reach_(discs_.offset),
    least_clearance_(clearance_between_checks(discs_.radius, discs_.offset, least_turning_radius(robot), stride_))
{}

CollisionChecker::CollisionChecker(const ObstacleMap& map, const Robot& robot, const std::vector<Pose>& tight)
  : CollisionChecker(map, robot)
{
  snug_ = snug_cover(robot);
  double least = robot.safety_margin;
  for (const Pose& pose : tight)
  {
    const double margin = std::clamp(fourwis::clearance(map, *snug_, pose) - kRounding, 0.0, robot.safety_margin);
    tight_.push_back({pose.x, pose.y, margin});
    least = std::min(least, margin);
  }
  needed_ = inscribed_discs(robot, least);
  const double inside = inscribed_discs(robot, 0.0).radius - snug_->radius;
  std::copy_if(snug_->centres.begin(), snug_->centres.end(), std::back_inserter(rim_), [&](const Point2& centre) {
    return std::hypot(std::abs(centre.x) - needed_.offset, centre.y) > inside;
  });
  stride_ = std::max(kLeastStride, least);
  reach_ = std::max(reach_, snug_->reach());
  least_clearance_ = clearance_between_checks(needed_.radius, needed_.offset, least_turning_radius(robot), stride_);
}

double CollisionChecker::margin_at(double x, double y) const
{
  double margin = robot_.safety_margin;
  for (const TightSpot& spot : tight_)
    if (std::hypot(x - spot.x, y - spot.y) < kTightSpot) margin = std::min(margin, spot.margin);
  return margin;
}

bool CollisionChecker::is_free(double x, double y, double cosine, double sine, double& clearance) const
{
  const double before = clearance;
  if (are_clear(discs_, x, y, cosine, sine, clearance)) return true;
  clearance = before;
  return snug_ && is_snug_free(x, y, cosine, sine, clearance);
}

bool CollisionChecker::are_clear(const TwoDiscs& discs, double x, double y, double cosine, double sine,
                                 double& clearance) const
{
  const double ox = discs.offset * cosine, oy = discs.offset * sine;
  return map_.is_clear(x + ox, y + oy, discs.radius, clearance) &&
         map_.is_clear(x - ox, y - oy, discs.radius, clearance);
}

bool CollisionChecker::is_snug_free(double x, double y, double cosine, double sine, double& clearance) const
{
  const double margin = margin_at(x, y), radius = snug_->radius + margin;
  if (!are_clear(inscribed_discs(robot_, margin), x, y, cosine, sine, clearance)) return false;
  return std::all_of(rim_.begin(), rim_.end(), [&](const Point2& centre) {
    return map_.is_clear(x + centre.x * cosine - centre.y * sine, y + centre.x * sine + centre.y * cosine, radius,
                         clearance);
  });
}

bool CollisionChecker::is_free(const Pose& pose) const
{
  double clearance = 0.0;
  return is_free(pose.x, pose.y, std::cos(pose.theta), std::sin(pose.theta), clearance);
}

double CollisionChecker::clearance(const Pose& pose) const
{
  const double two = fourwis::clearance(map_, {{{discs_.offset, 0.0}, {-discs_.offset, 0.0}}, discs_.radius}, pose);
  return snug_ ? std::max(two, fourwis::clearance(map_, *snug_, pose) - margin_at(pose.x, pose.y)) : two;
}

double CollisionChecker::free_length(const PathPiece& piece) const
{
  const double total = std::abs(piece.length), direction = piece.length < 0.0 ? -1.0 : 1.0;
  const Arc arc(robot_, piece.start, piece.mode, piece.phi);
  // A disc centre moves at most this much for each metre that C does.
  const double stretch = 1.0 + std::abs(arc.curvature()) * reach_;
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

double clearance(const ObstacleMap& map, const DiscCover& discs, const Pose& pose)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Point2& centre : discs.centres)
  {
    const Pose place = compose(pose, {centre.x, centre.y, 0.0});
    least = std::min(least, map.distance(place.x, place.y) - discs.radius);
  }
  return least;
}

}  // namespace fourwis
