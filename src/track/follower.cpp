#include "follower.h"

#include <algorithm>
#include <cmath>

namespace fourwis
{
namespace
{

/// The clock does not wait for the robot if the reference is slower than this [m/s].
constexpr double kSlow = 0.05;
/// The clock waits for at most this share of the time.
constexpr double kMostWait = 0.5;
/// The longitudinal error at which a stretch is at its end [m].
constexpr double kSettled = 0.002;
/// Wheels that are told to rest must be at rest after this time [s].
constexpr double kRestTimeout = 2.0;

}  // namespace

Follower::Follower(const Robot& robot, const TrackOptions& options)
  : robot_(robot),
    options_(options),
    period_(1.0 / options.controller_frequency),
    mpc_(robot, options),
    forecast_(robot, options),
    watch_(options),
    error_model_(robot, Mode::none),
    pace_(robot)
{}

void Follower::start(const Reference& reference, const SteeringRange& steering, const Measurement& now)
{
  reference_ = &reference;
  error_model_ = ErrorModel(robot_, reference.mode());
  mpc_.restart(reference.mode(), steering);
  forecast_.restart(reference.mode(), reference.start_phi());
  pace_.restart(reference.start_time() - now.period);
  watch_.restart();
  holding_ = -1.0;
  asked_ = {0.0, reference.start_phi()};
}

Follower::Answer Follower::step(const Measurement& now, bool go)
{
  Answer answer;
  answer.stop_reason = observe(now);
  const MotionState state = forecast_.ahead(now.pose, now.pose_stamp, now.now + options_.command_latency);
  pace_.advance(*reference_, go, now.period);
  wait_for_robot(state, now.period);
  if (answer.stop_reason) return answer;
  if (settles(state, now))
  {
    answer.command = rest(now);
    answer.finished = now.at_rest && holding_ > options_.command_latency + period_;
    if (holding_ > kRestTimeout) answer.stop_reason = {"the wheels do not come to rest for %.3f s", holding_};
    return answer;
  }
  if (!go && pace_.rate() == 0.0)
  {
    answer.command = come_to_rest(now);
    return answer;
  }
  const MpcAnswer control = mpc_.solve(*reference_, pace_, go, state);
  if (!control.usable)
    answer.stop_reason = {"the controller's problem has no solution"};
  else
    answer.command = ask(now, control.input, period_);
  return answer;
}

/// Compares the robot's pose with the reference, and its wheels with what they were asked for.
StopReason Follower::observe(const Measurement& now)
{
  const double age = now.now - now.pose_stamp;
  clock_ = pace_.rate() == 1.0 ? pace_.time() + now.period - options_.command_latency - age
                               : pace_.time() + pace_.rate() * (now.period - options_.command_latency - age);
  const MotionState& should = reference_->at(clock_).state;
  const ErrorState error = error_model_.error({now.pose, should.v, should.phi}, should);
  const double forward = should.v < 0.0 ? -1.0 : 1.0;
  deviation_ = {forward * error[1], forward * error[0], error[2]};

  forecast_.measured(now.wheel_stamp, mode_motion(robot_, reference_->mode(), now.wheels, asked_.phi));
  const double phi = forecast_.asked(now.wheel_stamp).phi;
  return watch_.judge(wheel_motion(robot_, reference_->mode(), 0.0, phi).angle, now.wheels.angle, now.period);
}

/// Slows the clock down if the robot lags behind by more than clock_slack. The clock must not stop, because before a
/// cusp the controller may find that not moving is best.
void Follower::wait_for_robot(const MotionState& state, double period)
{
  const MotionState& should = reference_->at(pace_.time()).state;
  const double ahead = error_model_.advance(error_model_.error(state, should));
  const double behind = (should.v < 0.0 ? ahead : -ahead) - options_.clock_slack;
  if (behind > 0.0 && std::abs(should.v) > kSlow)
    pace_.wait(std::min(kMostWait * period * pace_.rate(), behind / std::abs(should.v)));
}

/// Whether the robot is at the end of the stretch, so that its speed is set to 0.
bool Follower::settles(const MotionState& state, const Measurement& now)
{
  const double over = pace_.time() - reference_->end_time();
  if (over < 0.0) return false;
  if (holding_ >= 0.0)
  {
    holding_ += now.period;
    return true;
  }
  const double error = error_model_.advance(error_model_.error(state, reference_->at(pace_.time()).state));
  const bool near = std::abs(error) < kSettled && std::abs(asked_.v) < options_.rest_speed;
  if (near || over > options_.settle_time) holding_ = 0.0;
  return holding_ >= 0.0;
}

/// v and phi change by `input` for the coming control step. To compensate the lag of the wheels, they are told where
/// they should be a little later.
ModeMotion Follower::ask(const Measurement& now, const MotionInput& input, double duration)
{
  const ModeMotion from = forecast_.asked(now.now + options_.command_latency);
  asked_ = {from.v + input.a * duration, from.phi + input.omega * duration};
  forecast_.ask(now.now + options_.command_latency, asked_, duration);
  return {from.v + input.a * (0.5 * duration + options_.drive_lag),
          from.phi + input.omega * (0.5 * duration + options_.steering_lag)};
}

/// The speed is 0 from now on.
ModeMotion Follower::rest(const Measurement& now)
{
  const double v = forecast_.asked(now.now + options_.command_latency).v;
  ModeMotion still = ask(now, {-v / period_, 0.0}, period_);
  still.v = 0.0;
  return still;
}

/// Whatever the pose is: a robot that waits does not make up for a correction of its localisation.
ModeMotion Follower::come_to_rest(const Measurement& now)
{
  const double most = robot_.max_acceleration * period_;
  const double v = forecast_.asked(now.now + options_.command_latency).v;
  if (std::abs(v) <= most) return rest(now);
  return ask(now, {-std::copysign(robot_.max_acceleration, v), 0.0}, period_);
}

ModeMotion Follower::brake(const Measurement& now)
{
  const double forward = std::copysign(1.0, asked_.v);
  double speed = std::abs(asked_.v);
  if (now.usable) speed = std::min(speed, forward * mode_motion(robot_, reference_->mode(), now.wheels, asked_.phi).v);
  asked_.v = forward * std::max(0.0, speed - robot_.max_acceleration * now.period);
  return asked_;
}

}  // namespace fourwis
