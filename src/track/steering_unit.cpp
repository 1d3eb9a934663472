#include "steering_unit.h"

#include <algorithm>

#include "fourwis_navigation/vehicle/mode_traits.h"

namespace fourwis
{
namespace
{

/// Reserve beyond the steering angles of the stretch, for the controller. The first one that the wheels' travel allows
/// is taken [rad].
constexpr double kReserves[] = {0.2, 0.1, 0.05, 0.0};

}  // namespace

StopReason SteeringUnit::choose(Mode mode, double start, const SteeringRange& wanted, const PerWheel& measured)
{
  const double limit = max_phi(robot_, mode);
  BranchedMotion chosen;
  for (const double reserve : kReserves)
  {
    range_ = {std::min(wanted.low, std::max(wanted.low - reserve, -limit)),
              std::max(wanted.high, std::min(wanted.high + reserve, limit))};
    chosen = choose_branches(robot_, {mode, start, range_.low, range_.high}, measured);
    if (!chosen.beyond) break;
  }
  if (chosen.beyond)
    return {"wheel %.0f would have to turn to %.3f rad, beyond its travel", double(chosen.beyond->wheel),
            chosen.beyond->angle};
  mode_ = mode;
  last_ = chosen.motion;
  return {};
}

StopReason SteeringUnit::set(Mode mode, const ModeMotion& motion)
{
  BranchedMotion next = continue_branches(robot_, wheel_motion(robot_, mode, motion.v, motion.phi), last_.angle);
  if (next.beyond)
    return {"wheel %.0f would have to turn to %.3f rad, beyond its travel", double(next.beyond->wheel),
            next.beyond->angle};
  limit_speeds(next.motion, robot_.wheel_max_speed);
  mode_ = mode;
  last_ = next.motion;
  return {};
}

}  // namespace fourwis
