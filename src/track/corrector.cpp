#include "corrector.h"

#include <algorithm>
#include <cmath>

#include "creep.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "guard.h"

namespace fourwis
{
namespace
{

constexpr TrajectoryPoint kPlaceholder = {};

/// Longest correction of a robot that is as far away as it may be [s].
double longest(const Robot& robot, const TrackOptions& options)
{
  const double way = std::max(options.max_xy_correction, options.max_yaw_correction * spin_radius(robot));
  return 4.0 + way / options.correction_speed;
}

}  // namespace

bool RestTarget::is_reached(const Pose& at) const
{
  return is_within(at, pose, xy_tolerance, yaw_tolerance);
}

Corrector::Corrector(const Robot& robot, const TrackOptions& options)
  : robot_(robot),
    options_(options),
    stretch_(robot, &kPlaceholder, &kPlaceholder + 1)
{
  stretch_.reserve(longest(robot, options));
}

bool Corrector::is_near(const Pose& at, const RestTarget& to) const
{
  return is_within(at, to.pose, options_.max_xy_correction, options_.max_yaw_correction);
}

bool Corrector::start(const Pose& from, const RestTarget& to)
{
  if (spent_ > options_.correction_timeout) return false;
  const double turn = wrap_angle(to.pose.theta - from.theta);
  const Creep creep = std::abs(turn) > to.yaw_tolerance ? creeping_turn(robot_, from, turn, options_.correction_speed)
                                                        : creeping_shift(from, to.pose, options_.correction_speed);
  stretch_.assign(creep.data(), creep.data() + creep.size());
  active_ = true;
  return true;
}

void Corrector::finish()
{
  active_ = false;
  spent_ = 0.0;
}

}  // namespace fourwis
