#include "interlock.h"

#include <algorithm>
#include <cmath>

namespace fourwis::can
{
namespace
{

/// A command that turns a wheel by more than this at once does not continue the motion [rad].
constexpr double kLargestJump = 20.0 * M_PI / 180.0;

}  // namespace

Interlock::Interlock(const BridgeOptions& options)
  : tolerance_(options.aligned_tolerance),
    standstill_speed_(options.standstill_speed),
    standstill_(options.standstill_time),
    aligned_(options.aligned_time),
    rolls_on_(options.stop_timeout),
    late_(options.alignment_timeout)
{}

void Interlock::reset(double now)
{
  standstill_.reset();
  aligned_.reset();
  rolls_on_.reset();
  late_.reset();
  stands_ = standstill_.holds(now);
  aligned_now_ = overdue_ = false;
  phase_ = Phase::holding;
  mode_ = Mode::none;
}

WheelMotion Interlock::permit(const WheelCommand& command, const WheelMotion& measured, const WheelMotion& setpoint,
                              double now)
{
  observe(command, measured, setpoint, now);
  phase_ = next_phase(command, measured, setpoint);
  if (phase_ != Phase::holding) mode_ = command.mode;
  const bool waits = phase_ == Phase::holding && command.mode != Mode::none;
  overdue_ = rolls_on_.update(waits, now) | late_.update(phase_ == Phase::turning && !aligned_now_, now);
  if (phase_ == Phase::holding) return {setpoint.angle, {}};
  if (phase_ == Phase::turning) return {command.motion.angle, {}};
  return command.motion;
}

void Interlock::observe(const WheelCommand& command, const WheelMotion& measured, const WheelMotion& setpoint,
                        double now)
{
  const PerWheel& wanted = command.mode == Mode::none ? setpoint.angle : command.motion.angle;
  if (greatest_gap(wanted, commanded_) > tolerance_)
  {
    aligned_.reset();
    late_.reset();
  }
  commanded_ = wanted;
  // The set-point counts as well: a base that steers by itself may have reached the angle before it was commanded.
  const double gap = std::max(greatest_gap(measured.angle, wanted), greatest_gap(setpoint.angle, wanted));
  aligned_now_ = aligned_.update(gap <= tolerance_, now);
  const double fastest = std::max(greatest_magnitude(measured.speed), greatest_magnitude(setpoint.speed));
  stands_ = standstill_.update(fastest <= standstill_speed_, now);
}

Interlock::Phase Interlock::next_phase(const WheelCommand& command, const WheelMotion& measured,
                                       const WheelMotion& setpoint) const
{
  if (command.mode == Mode::none) return Phase::holding;
  const PerWheel& wanted = command.motion.angle;
  const bool other = command.mode != mode_ || greatest_gap(wanted, setpoint.angle) > kLargestJump;
  const bool off = command.mode != mode_ || greatest_gap(wanted, measured.angle) > tolerance_;
  switch (phase_)
  {
    case Phase::holding: return stands_ ? Phase::turning : Phase::holding;
    // Wheels may roll a little while they turn. Turning goes on.
    case Phase::turning: return aligned_now_ ? Phase::driving : Phase::turning;
    case Phase::driving: break;
  }
  if (stands_) return off ? Phase::turning : Phase::driving;
  return other ? Phase::holding : Phase::driving;
}

}  // namespace fourwis::can
