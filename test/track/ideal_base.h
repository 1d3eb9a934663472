#pragma once

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/vehicle/wheel_twist.h"

namespace fourwis
{

/// A base whose wheels reach the commanded speeds at once and turn at their greatest rate. Its body moves as they roll.
class IdealBase
{
public:
  IdealBase(const Robot& robot, const Pose& pose) : robot_(robot), twist_(robot, {}), pose_(pose)
  {
    state_.state = BaseState::enabled;
  }

  /// Carries out `command` for `duration`.
  void step(const WheelCommand& command, double duration)
  {
    constexpr int parts = 20;
    if (command.mode != Mode::none) wanted_ = command.motion.angle;
    for (int part = 0; part < parts; ++part) move(command, duration / parts);
    state_.stamp += duration;
    state_.mode = command.mode;
    state_.sequence = command.sequence;
    state_.aligned = true;
    for (std::size_t i = 0; i < wanted_.size(); ++i)
      state_.aligned &= std::abs(wanted_[i] - state_.motion.angle[i]) < 1e-6;
  }

  const Pose& pose() const { return pose_; }
  const WheelState& wheels() const { return state_; }
  void push(const Pose& to) { pose_ = to; }

private:
  void move(const WheelCommand& command, double h)
  {
    for (std::size_t i = 0; i < wanted_.size(); ++i)
    {
      const double turn = wanted_[i] - state_.motion.angle[i], most = h * robot_.wheel_max_rate;
      state_.motion.angle[i] += std::clamp(turn, -most, most);
      state_.motion.speed[i] = command.mode == Mode::none ? 0.0 : command.motion.speed[i];
    }
    const Twist twist = twist_.estimate(state_.motion).twist;
    const double middle = pose_.theta + 0.5 * h * twist.omega;
    pose_.x += h * (std::cos(middle) * twist.vx - std::sin(middle) * twist.vy);
    pose_.y += h * (std::sin(middle) * twist.vx + std::cos(middle) * twist.vy);
    pose_.theta += h * twist.omega;
  }

  const Robot robot_;
  WheelTwist twist_;
  Pose pose_;
  PerWheel wanted_{};
  WheelState state_;
};

}  // namespace fourwis
