#include "fourwis_navigation/map/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fourwis_navigation/map/body_overlap.h"
#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_limits.h"

namespace fourwis
{
namespace
{

/// Shortest stride along a motion where the safety margin is small or zero [m].
constexpr double kLeastStride = 0.005;
/// What the body keeps at least where nothing else is asked for: what may be missed between two checks [m].
constexpr double kLeastMargin = 0.0005;
/// By how much more than its margin the body is tried to be free, in sizes of the robot: then the next check is so far away.
constexpr double kRooms[] = {0.03, 0.06, 0.12, 0.24};
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
  const DriveLimits limits(robot);
  for (Mode mode : kPlannedModes)
    if (limits[mode].curvature > 0.0) least = std::min(least, 1.0 / limits[mode].curvature);
  return least;
}

}  // namespace

CollisionChecker::CollisionChecker(const ObstacleMap& map, const Robot& robot)
  : map_(map),
    robot_(checked(robot)),
    discs_(two_discs(robot)),
    needed_(discs_),
    with_margin_(grown(body_of(robot), std::max(robot.safety_margin, kLeastMargin))),
    stride_(std::max(kLeastStride, robot.safety_margin)),
    reach_(discs_.reach()),
    least_clearance_(clearance_between_checks(discs_.radius, discs_.reach(), least_turning_radius(robot), stride_))
{}

CollisionChecker::CollisionChecker(const ObstacleMap& map, const Robot& robot, const std::vector<Pose>& tight)
  : CollisionChecker(map, robot)
{
  const ConvexPolygon body = body_of(robot);
  const double usual = std::max(robot.safety_margin, kLeastMargin);
  double least = robot.safety_margin;
  for (const Pose& pose : tight)
  {
    const double margin = std::max(0.0, body_clearance(map, body, pose, usual + kRounding) - kRounding);
    if (margin >= usual) continue;
    tight_.push_back({pose.x, pose.y, margin, grown(body, margin)});
    least = std::min(least, margin);
  }
  goes_by_body_ = true;
  // Two discs that cover the body with its margin: they only save the look at the body.
  const BodyBox box = box_of(robot);
  discs_.radius = std::hypot(box.length / 4.0 + usual, box.width / 2.0 + usual);
  needed_ = inscribed_discs(robot, least);
  for (double by : kRooms) larger_.push_back({by * robot.size(), grown(with_margin_, by * robot.size())});
  stride_ = std::max(kLeastStride, least);
  reach_ = std::max(reach_, reach_of(with_margin_));
  least_clearance_ = clearance_between_checks(needed_.radius, needed_.reach(), least_turning_radius(robot), stride_);
}

const ConvexPolygon& CollisionChecker::with_margin_at(double x, double y) const
{
  const TightSpot* least = nullptr;
  for (const TightSpot& spot : tight_)
    if (spot.is_near(x, y) && (!least || spot.margin < least->margin)) least = &spot;
  return least ? least->with_margin : with_margin_;
}

bool CollisionChecker::is_free(double x, double y, double cosine, double sine, double& clearance) const
{
  const double before = clearance;
  if (are_clear(discs_, x, y, cosine, sine, clearance)) return true;
  clearance = before;
  if (!goes_by_body() || !are_clear(needed_, x, y, cosine, sine, clearance)) return false;
  clearance = 0.0;
  return is_clear(map_, with_margin_at(x, y), {x, y, cosine, sine});
}

/// Where the body is free by how much it is at least [m]. `step` is that of the pose before, and then of this one.
double CollisionChecker::room(double x, double y, double cosine, double sine, std::size_t& step) const
{
  const auto has = [&](std::size_t i) { return is_clear(map_, larger_[i].outline, {x, y, cosine, sine}); };
  if (step > 0 && !has(step - 1))
    while (--step > 0 && !has(step - 1)) continue;
  else if (step < larger_.size() && has(step))
    ++step;
  return step > 0 ? larger_[step - 1].by : 0.0;
}

bool CollisionChecker::are_clear(const TwoDiscs& discs, double x, double y, double cosine, double sine,
                                 double& clearance) const
{
  const double ox = discs.offset * cosine, oy = discs.offset * sine;
  x += discs.middle.x * cosine - discs.middle.y * sine;
  y += discs.middle.x * sine + discs.middle.y * cosine;
  return map_.is_clear(x + ox, y + oy, discs.radius, clearance) &&
         map_.is_clear(x - ox, y - oy, discs.radius, clearance);
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
  const double stretch = 1.0 + std::abs(arc.curvature()) * reach_;
  double free = 0.0;
  std::size_t room_step = 0;
  for (double s = 0.0;;)
  {
    const Arc::Placement placement = arc.at(direction * s);
    double clearance = kFarClearance;
    if (!is_free(placement.x, placement.y, placement.cosine, placement.sine, clearance)) return free;
    free = s;
    if (s >= total) return total;
    if (goes_by_body() && clearance < stride_)
      clearance = room(placement.x, placement.y, placement.cosine, placement.sine, room_step);
    s = std::min(total, s + std::max(stride_, clearance) / stretch);
  }
}

}  // namespace fourwis
