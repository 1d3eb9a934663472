#include "fourwis_navigation/sim/base_simulator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis
{
namespace
{

constexpr OptionRange kDurations{0.0, 1e6, "s"};

const SimulatorOptions& checked(const Robot& robot, const SimulatorOptions& options)
{
  check(robot, options);
  return options;
}

bool is_usable(const WheelCommand& command)
{
  const auto finite = [](double value) { return std::isfinite(value); };
  const PerWheel &angle = command.motion.angle, &speed = command.motion.speed;
  return is_mode(command.mode) && std::all_of(angle.begin(), angle.end(), finite) &&
         std::all_of(speed.begin(), speed.end(), finite);
}

}  // namespace

BaseSimulator::BaseSimulator(const Robot& robot, const SimulatorOptions& options)
  : options_(checked(robot, options)),
    max_speed_(robot.wheel_max_speed),
    plant_(robot, options.actuators, options.slip),
    encoders_(options.encoders, options.seed),
    interlock_(options.interlock)
{
  encoders_.measure(plant_.wheels());
}

void BaseSimulator::place(const Pose& pose)
{
  plant_.place(pose);
  pending_.clear();
  taken_.mode = Mode::none;
  speeds_ = {};
  interlock_.reset();
  encoders_.measure(plant_.wheels());
}

bool BaseSimulator::command(const WheelCommand& command)
{
  if (!is_usable(command)) return false;
  const auto latency = std::llround(options_.command_latency / options_.time_step);
  pending_.push_back({steps_ + latency, command});
  return true;
}

void BaseSimulator::step(double duration)
{
  require_in(kDurations, "duration", duration);
  remainder_ += duration;
  const auto steps = static_cast<std::int64_t>(std::floor(remainder_ / options_.time_step + 1e-6));
  remainder_ -= static_cast<double>(steps) * options_.time_step;
  for (std::int64_t i = 0; i < steps; ++i) step_once();
}

void BaseSimulator::step_once()
{
  take_commands();
  watch();
  control();
  plant_.step(options_.time_step);
  encoders_.measure(plant_.wheels());
  interlock_.step(options_.time_step, encoders_.measured());
  ++steps_;
}

void BaseSimulator::take_commands()
{
  while (!pending_.empty() && pending_.front().due <= steps_)
  {
    if (state_ == BaseState::enabled)
    {
      taken_ = pending_.front().command;
      taken_at_ = steps_;
      interlock_.command(taken_.mode, taken_.motion.angle);
    }
    pending_.pop_front();
  }
}

/// Changes the state when commands are missing, wheels do not turn in time, or a stop is over.
void BaseSimulator::watch()
{
  const double silence = static_cast<double>(steps_ - taken_at_) * options_.time_step;
  if (interlock_.stage() == Interlock::Stage::failed)
    state_ = BaseState::fault;
  else if (state_ == BaseState::stopping && interlock_.at_standstill())
    state_ = BaseState::enabled;
  else if (state_ == BaseState::enabled && taken_.mode != Mode::none && silence > options_.command_timeout)
  {
    state_ = BaseState::stopping;
    taken_.mode = Mode::none;
    interlock_.reset();
  }
}

void BaseSimulator::control()
{
  const PerWheel angles = interlock_.may_turn() ? taken_.motion.angle : plant_.wheels().angle;
  for (int i = 0; i < kWheels; ++i) plant_.set_steering_target(i, angles[static_cast<std::size_t>(i)]);
  if (!interlock_.may_drive()) return stop();
  WheelMotion wanted = taken_.motion;
  limit_speeds(wanted, max_speed_);
  set_speeds(wanted.speed);
}

/// Reduces the speeds of all wheels by one factor, so that the body keeps its path.
void BaseSimulator::stop()
{
  WheelMotion slower{{}, speeds_};
  const double most = greatest_magnitude(speeds_) - options_.stop_deceleration * options_.time_step;
  limit_speeds(slower, std::max(0.0, most));
  set_speeds(slower.speed);
}

void BaseSimulator::set_speeds(const PerWheel& speeds)
{
  speeds_ = speeds;
  for (int i = 0; i < kWheels; ++i) plant_.set_drive_target(i, speeds_[static_cast<std::size_t>(i)]);
}

WheelState BaseSimulator::wheels() const
{
  return {time(), state_, taken_.mode, taken_.sequence, encoders_.measured(), interlock_.aligned()};
}

void BaseSimulator::inject(const WheelFault& fault)
{
  if (fault.wheel < 0 || fault.wheel >= kWheels) throw std::out_of_range("wheel " + std::to_string(fault.wheel));
  switch (fault.kind)
  {
    case WheelFault::Kind::stuck_steering: return plant_.power_steering(fault.wheel, false);
    case WheelFault::Kind::dead_drive: return plant_.power_drive(fault.wheel, false);
    case WheelFault::Kind::frozen_encoders: return encoders_.freeze(fault.wheel);
  }
}

void BaseSimulator::clear_faults()
{
  for (int i = 0; i < kWheels; ++i)
  {
    plant_.power_steering(i, true);
    plant_.power_drive(i, true);
  }
  encoders_.release_all();
  if (state_ != BaseState::fault) return;
  state_ = BaseState::stopping;
  taken_.mode = Mode::none;
  interlock_.reset();
}

}  // namespace fourwis
