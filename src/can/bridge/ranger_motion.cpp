#include "ranger_motion.h"

#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis::can
{
namespace
{

/// Side-slip is exact when the wheels' common steering angle is less than this [rad].
constexpr double kNoSteering = 0.01;

struct Counterpart
{
  Mode mode;
  RangerMode base;
};

/// The base's modes and ours.
constexpr Counterpart kCounterparts[] = {
    {Mode::none, RangerMode::park},         {Mode::ackermann, RangerMode::dual_ackermann},
    {Mode::lateral, RangerMode::side_slip}, {Mode::parallel, RangerMode::parallel},
    {Mode::spin, RangerMode::spin},
};
static_assert(has_a_row_for_each_mode(kCounterparts));

RangerMode counterpart(Mode mode)
{
  return kCounterparts[index_of(mode)].base;
}

}  // namespace

const char* RangerKinematics::refusal(const WheelCommand& command) const
{
  if (counterpart(command.mode) != RangerMode::side_slip) return nullptr;
  const double phi = mode_motion(robot_, command.mode, command.motion).phi;
  return std::abs(phi) > kNoSteering ? "lateral motion with steering: this base knows side-slip only" : nullptr;
}

RangerMode RangerKinematics::base_mode(Mode mode) const
{
  const RangerMode base = counterpart(mode);
  return base == RangerMode::side_slip ? static_cast<RangerMode>(options_.side_slip_mode) : base;
}

RangerMotion RangerKinematics::base_motion(Mode mode, const WheelMotion& wheels, double near_steering) const
{
  const ModeMotion motion = mode_motion(robot_, mode, wheels, near_steering);
  RangerMotion base;
  switch (counterpart(mode))
  {
    case RangerMode::park: break;
    case RangerMode::dual_ackermann:
      base.speed = motion.v;
      base.steering = inner_angle(mode, motion.phi);
      break;
    case RangerMode::side_slip: base.lateral = motion.v; break;
    case RangerMode::parallel:
      base.speed = motion.v;
      base.steering = motion.phi;
      break;
    case RangerMode::spin:
      if (options_.spin_by_speed)
        base.lateral = motion.v;
      else
        base.yaw = motion.v / spin_radius(robot_);
      break;
  }
  return base;
}

/// The base's steering angle is that of the inner front wheel, which turns further than the outer one.
double RangerKinematics::inner_angle(Mode mode, double phi) const
{
  const WheelMotion forward = wheel_motion(robot_, mode, 1.0, phi);
  const double left = forward.angle[0], right = forward.angle[1];
  return std::abs(left) > std::abs(right) ? left : right;
}

WheelMotion RangerKinematics::measured(const PerWheel& angles, const PerWheel& speeds, const PerWheel& told) const
{
  WheelMotion motion;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const auto place = static_cast<std::size_t>(options_.place[i] - 1);
    const double half_turns = std::round((told[i] - angles[place]) / M_PI);
    motion.angle[i] = angles[place] + half_turns * M_PI;
    motion.speed[i] = std::remainder(half_turns, 2.0) == 0.0 ? speeds[place] : -speeds[place];
  }
  return motion;
}

}  // namespace fourwis::can
