#include "power_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fourwis::drives
{
namespace
{

constexpr std::uint16_t kHalt = 0x100, kFaultReset = 0x80;
constexpr std::uint16_t kDisableVoltage = 0x00, kQuickStop = 0x02;
constexpr std::uint16_t kWarning = 1 << 7, kRemote = 1 << 9, kTargetReached = 1 << 10, kFollows = 1 << 12,
                        kFollowingError = 1 << 13;
constexpr std::int64_t kNoWindow = 0xFFFFFFFF;

/// Quick stop option codes.
constexpr int kAtOnce = 0, kProfileThenHold = 5, kQuickThenHold = 6;

/// Counters of 32 bits wrap around.
std::int64_t counter(double counts)
{
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(std::llround(counts)));
}

std::int64_t saturated(double counts)
{
  return std::llround(std::clamp(counts, -2147483648.0, 2147483647.0));
}

}  // namespace

PowerStage::PowerStage(ObjectDictionary& dictionary, double max_velocity)
  : dictionary_(dictionary),
    setpoints_(dictionary, max_velocity),
    homing_(dictionary)
{}

void PowerStage::become_ready()
{
  enter(PowerState::switch_on_disabled);
}

bool PowerStage::is_powered() const
{
  return state_ == PowerState::operation_enabled || state_ == PowerState::quick_stop_active ||
         state_ == PowerState::fault_reaction;
}

bool PowerStage::is_halted() const
{
  return (controlword_ & kHalt) != 0;
}

void PowerStage::written(ObjectAddress address)
{
  if (address.index == object::kControlword) command(static_cast<std::uint16_t>(dictionary_.get(object::kControlword)));
  if (address.index == object::kMode) adopt_mode();
  if (address.index == object::kTargetPosition) setpoints_.target_written();
}

void PowerStage::command(std::uint16_t controlword)
{
  const std::uint16_t previous = std::exchange(controlword_, controlword);
  const bool reset = (controlword & ~previous & kFaultReset) != 0;
  const bool was_enabled = state_ == PowerState::operation_enabled;
  enter(next_power_state(state_, controlword, reset, option(object::kQuickStopOption) >= kProfileThenHold));
  if (!was_enabled || state_ != PowerState::operation_enabled) return;
  if (mode() == mode_of_operation::kProfilePosition) setpoints_.command(controlword, previous);
  if (mode() != mode_of_operation::kHoming) return;
  if (const std::optional<double> home = homing_.command(controlword, previous))
  {
    shift_ += *home - measured_.position;
    measured_.position = *home;
    setpoints_.start(measured_);
  }
}

void PowerStage::enter(PowerState next)
{
  if (next == state_) return;
  const bool was_powered = is_powered();
  state_ = next;
  if (state_ == PowerState::quick_stop_active && option(object::kQuickStopOption) == kAtOnce)
    state_ = PowerState::switch_on_disabled;
  if (state_ == PowerState::fault_reaction && (!was_powered || option(object::kFaultReactionOption) == kAtOnce))
    state_ = PowerState::fault;
  if (is_powered()) setpoints_.start(measured_);
  following_off_ = 0.0;
  following_error_ = following_error_ && (state_ == PowerState::fault_reaction || state_ == PowerState::fault);
}

void PowerStage::adopt_mode()
{
  const std::int64_t mode = dictionary_.get(object::kMode);
  if (mode == dictionary_.get(object::kModeDisplay)) return;
  dictionary_.set(object::kModeDisplay, mode);
  if (is_powered()) setpoints_.start(measured_);
}

void PowerStage::lose_connection()
{
  switch (option(object::kAbortConnection))
  {
    case 1: return fail();
    case 2: return enter(next_power_state(state_, kDisableVoltage, false, false));
    case 3: return enter(next_power_state(state_, kQuickStop, false, false));
    default: return;
  }
}

void PowerStage::fail()
{
  if (state_ != PowerState::fault) enter(PowerState::fault_reaction);
}

bool PowerStage::advance(double dt, const AxisMotion& motor)
{
  measured_ = {motor.position + shift_, motor.velocity};
  if (is_powered()) move(dt);
  return watch_following(dt);
}

void PowerStage::move(double dt)
{
  switch (state_)
  {
    case PowerState::quick_stop_active:
    {
      const int ending = option(object::kQuickStopOption);
      setpoints_.brake(deceleration(ending == 2 || ending == kQuickThenHold), dt);
      if (ending < kProfileThenHold && setpoints_.at_rest()) enter(PowerState::switch_on_disabled);
      return;
    }
    case PowerState::fault_reaction:
      setpoints_.brake(deceleration(option(object::kFaultReactionOption) == 2), dt);
      if (setpoints_.at_rest()) enter(PowerState::fault);
      return;
    default:
      if (is_halted())
        setpoints_.brake(deceleration(option(object::kHaltOption) == 2), dt);
      else
        setpoints_.follow(dt);
  }
}

double PowerStage::deceleration(bool quick) const
{
  return static_cast<double>(dictionary_.get(quick ? object::kQuickStopDeceleration : object::kProfileDeceleration));
}

bool PowerStage::watch_following(double dt)
{
  const std::int64_t window = dictionary_.get(object::kFollowingWindow);
  const bool watched = state_ == PowerState::operation_enabled && setpoints_.demands_position() && window != kNoWindow;
  const double error = setpoints_.demand().value - measured_.position;
  following_off_ = watched && std::abs(error) > static_cast<double>(window) ? following_off_ + dt : 0.0;
  if (following_off_ * 1e3 <= static_cast<double>(dictionary_.get(object::kFollowingTime))) return false;
  following_error_ = true;
  return true;
}

AxisDemand PowerStage::demand() const
{
  if (!is_powered()) return {};
  AxisDemand demand = setpoints_.demand();
  if (demand.kind == AxisDemand::Kind::position) demand.value -= shift_;
  return demand;
}

std::uint16_t PowerStage::statusword() const
{
  std::uint16_t word = power_status(state_) | kRemote;
  if (warning_) word |= kWarning;
  if (following_error_) word |= kFollowingError;
  const bool stops = state_ == PowerState::quick_stop_active || (is_powered() && is_halted());
  if (stops && setpoints_.at_rest()) word |= kTargetReached;
  if (mode() == mode_of_operation::kHoming) return word | homing_.status();
  if (state_ != PowerState::operation_enabled) return word;
  const int hidden = is_halted() ? kFollows | kTargetReached : 0;
  return static_cast<std::uint16_t>(word | (setpoints_.status(measured_) & ~hidden));
}

void PowerStage::publish()
{
  dictionary_.set(object::kStatusword, statusword());
  dictionary_.set(object::kPositionActual, counter(measured_.position));
  dictionary_.set(object::kVelocityActual, saturated(measured_.velocity));
}

}  // namespace fourwis::drives
