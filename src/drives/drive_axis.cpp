#include "drive_axis.h"

#include <cmath>

namespace fourwis::drives
{
namespace
{

/// The greatest velocity of the drives, relative to the limit of the robot.
constexpr double kSpeedReserve = 1.2;
/// A steering axis that is further from its set-point than this has a following error [rad].
constexpr double kFollowingWindow = 20.0 * M_PI / 180.0;
/// Deceleration of a quick stop in the delivery state: steering [rad/s^2], driving [m/s^2].
constexpr double kSteeringStop = 30.0, kDrivingStop = 5.0;
/// Speed of a wheel per metre of distance from its target position [1/s].
constexpr double kPositionGain = 20.0;

/// Counts of the drive for each unit of an axis that a whole turn moves by `turn` [rad or m]; negative where it is
/// reversed. On purpose not the bridge's own conversion, so that a mistake in one of both is noticed.
double counts_per_unit(const can::AxisOptions& axis, double turn)
{
  const double counts = axis.counts_per_turn * axis.gear_ratio / turn;
  return axis.reversed ? -counts : counts;
}

/// Of an axis with that many counts that moves up to `speed` and stops with `deceleration`, in its own unit.
DriveOptions drive_options(const can::BridgeOptions& options, int node, double counts_per_unit, double speed,
                           double deceleration)
{
  const double counts = std::abs(counts_per_unit);
  DriveOptions drive;
  drive.node = static_cast<std::uint8_t>(node);
  drive.serial = static_cast<std::uint32_t>(node);
  if (options.vendor_id > 0) drive.vendor = options.vendor_id;
  if (options.product_code > 0) drive.product = options.product_code;
  drive.profile_velocity = speed * counts;
  drive.max_velocity = kSpeedReserve * speed * counts;
  drive.acceleration = drive.quick_stop = deceleration * counts;
  drive.following_window = kFollowingWindow * counts;
  return drive;
}

}  // namespace

DriveAxis::DriveAxis(const can::AxisOptions& axis, double counts_per_unit, int wheel, bool steers,
                     const DriveOptions& drive)
  : node_(axis.node),
    wheel_(wheel),
    steers_(steers),
    counts_per_unit_(counts_per_unit),
    offset_(steers ? axis.offset : 0.0),
    drive_(drive)
{}

DriveAxis DriveAxis::steering(const Robot& robot, const can::BridgeOptions& options, int wheel)
{
  const can::AxisOptions& axis = options.steering[static_cast<std::size_t>(wheel)];
  const double counts = counts_per_unit(axis, 2.0 * M_PI);
  return {axis, counts, wheel, true, drive_options(options, axis.node, counts, robot.wheel_max_rate, kSteeringStop)};
}

DriveAxis DriveAxis::driving(const Robot& robot, const can::BridgeOptions& options, int wheel)
{
  const can::AxisOptions& axis = options.driving[static_cast<std::size_t>(wheel)];
  const double counts = counts_per_unit(axis, 2.0 * M_PI * options.wheel_radius);
  return {axis, counts, wheel, false, drive_options(options, axis.node, counts, robot.wheel_max_speed, kDrivingStop)};
}

void DriveAxis::measure(const Plant& plant, double now, double dt)
{
  const double before = position_;
  position_ = steers_ ? plant.angle(wheel_) : before + plant.speed(wheel_) * dt;
  motor_.position = (position_ - offset_) * counts_per_unit_;
  motor_.velocity = (position_ - before) / dt * counts_per_unit_;
  drive_.advance(now, motor_);
}

void DriveAxis::actuate(Plant& plant, double dt, bool stuck, bool dead)
{
  const AxisDemand demand = drive_.demand();
  const bool powered = demand.kind != AxisDemand::Kind::off && !dead;
  if (steers_)
    steer(plant, demand, dt, powered && !stuck);
  else
    roll(plant, demand, stuck, powered || stuck);
}

void DriveAxis::steer(Plant& plant, const AxisDemand& demand, double dt, bool powered)
{
  const bool position = demand.kind == AxisDemand::Kind::position;
  const double unit = demand.value / counts_per_unit_;
  if (!powered)
    reference_ = position_;
  else
    reference_ = position ? unit + offset_ : reference_ + unit * dt;
  plant.power_steering(wheel_, powered);
  plant.set_steering_target(wheel_, reference_);
}

void DriveAxis::roll(Plant& plant, const AxisDemand& demand, bool stuck, bool powered)
{
  const bool position = demand.kind == AxisDemand::Kind::position;
  const double speed = position ? (demand.value - motor_.position) * kPositionGain : demand.value;
  plant.power_drive(wheel_, powered);
  plant.set_drive_target(wheel_, stuck ? 0.0 : speed / counts_per_unit_);
}

}  // namespace fourwis::drives
