#include "ranger_motion.h"

#include <cmath>

#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis::can
{
namespace
{

/// Side-slip is exact when the wheels' common steering angle is less than this [rad].
constexpr double kNoSteering = 0.01;

}  // namespace

const char* RangerKinematics::refusal(const WheelCommand& command) const
{
  if (command.mode != Mode::lateral) return nullptr;
  const double phi = mode_motion(robot_, Mode::lateral, command.motion).phi;
  return std::abs(phi) > kNoSteering ? "lateral motion with steering: this base knows side-slip only" : nullptr;
}

RangerMode RangerKinematics::base_mode(Mode mode) const
{
  switch (mode)
  {
    case Mode::none: break;
    case Mode::ackermann: return RangerMode::dual_ackermann;
    case Mode::lateral: return static_cast<RangerMode>(options_.side_slip_mode);
    case Mode::parallel: return RangerMode::parallel;
    case Mode::spin: return RangerMode::spin;
  }
  return RangerMode::park;
}

RangerMotion RangerKinematics::base_motion(Mode mode, const WheelMotion& wheels, double near_steering) const
{
  const ModeMotion motion = mode_motion(robot_, mode, wheels, near_steering);
  RangerMotion base;
  switch (mode)
  {
    case Mode::none: break;
    case Mode::ackermann: return ackermann(wheels);
    case Mode::lateral: base.lateral = motion.v; break;
    case Mode::parallel:
      base.speed = motion.v;
      base.steering = motion.phi;
      break;
    case Mode::spin:
      if (options_.spin_by_speed)
        base.lateral = motion.v;
      else
        base.yaw = motion.v / (std::hypot(robot_.wheelbase, robot_.track_width) / 2.0);
      break;
  }
  return base;
}

/// The steering angle is that of the inner wheel, of the larger of both in front.
RangerMotion RangerKinematics::ackermann(const WheelMotion& wheels) const
{
  const ModeMotion motion = mode_motion(robot_, Mode::ackermann, wheels);
  const WheelMotion forward = wheel_motion(robot_, Mode::ackermann, 1.0, motion.phi);
  const double left = forward.angle[0], right = forward.angle[1];
  RangerMotion base;
  base.speed = motion.v;
  base.steering = std::abs(left) > std::abs(right) ? left : right;
  return base;
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
