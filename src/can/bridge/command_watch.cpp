#include "command_watch.h"

#include <cmath>

namespace fourwis::can
{
namespace
{

/// Rounding by which an angle may exceed the travel of a wheel [rad].
constexpr double kAngleSlack = 1e-3;
/// A command whose sequence is behind by at least this much comes from a sender that has started anew.
constexpr std::int32_t kMostOvertaken = 100;

}  // namespace

CommandWatch::Verdict CommandWatch::take(const WheelCommand& command, double made, double now)
{
  if (!is_valid(command)) return Verdict::invalid;
  if (now - made > timeout_) return Verdict::late;
  const auto ahead = static_cast<std::int32_t>(command.sequence - newest_.sequence);
  if (any_ && !expired(now) && ahead <= 0 && ahead > -kMostOvertaken) return Verdict::overtaken;
  newest_ = command;
  made_ = made;
  any_ = true;
  return Verdict::taken;
}

void CommandWatch::reset()
{
  any_ = false;
  newest_.mode = Mode::none;
  newest_.motion.speed = {};
}

bool CommandWatch::is_valid(const WheelCommand& command) const
{
  if (!is_mode(command.mode)) return false;
  if (command.mode == Mode::none) return true;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    // Written so that NaN, too, is refused.
    if (!(std::abs(command.motion.angle[i]) <= max_angle_ + kAngleSlack)) return false;
    if (!std::isfinite(command.motion.speed[i])) return false;
  }
  return true;
}

}  // namespace fourwis::can
