#include "sequencer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fourwis_navigation/track/step_number.h"

namespace fourwis
{
namespace
{

/// If the robot is not measured to be at rest, it counts as at rest this long after it should be [s].
constexpr double kUnseenRestTime = 1.0;

}  // namespace

Sequencer::Sequencer(const Robot& robot, const TrackOptions& options)
  : robot_(robot),
    options_(options),
    observer_(options),
    follower_(robot, options),
    steering_(robot),
    corrector_(robot, options),
    measured_(observer_.measured())
{}

void Sequencer::take(Mission& mission)
{
  next_.swap(mission);
  has_next_ = true;
  if (is_under_way()) brake_for({});
}

void Sequencer::stop()
{
  has_next_ = false;
  if (is_under_way())
    brake_for({});
  else if (state_ != TrackState::stopping)
    enter(TrackState::idle);
}

TrackOutput Sequencer::step(const TrackInput& input)
{
  number(input.now);
  if (has_next_ && rests()) observer_.restart_clock();
  const StopReason reason = observer_.observe(input);
  elapsed_ += measured_.period;
  if (!waits_for_) corrector_.pass(measured_.period);
  TrackOutput output;
  waits_for_ = {};
  output.command = act(input, reason);
  output.command.sequence = sequence_;
  report(output);
  return output;
}

/// Commands have the numbers of the control steps. So a new controller does not repeat the numbers of the one before,
/// and a replay repeats the recorded numbers.
void Sequencer::number(double now)
{
  const auto step = static_cast<std::uint32_t>(step_number(now, options_.controller_frequency));
  const bool advances = static_cast<std::int32_t>(step - sequence_) > 0;
  sequence_ = advances || !numbered_ ? step : sequence_ + 1;
  numbered_ = true;
}

WheelCommand Sequencer::act(const TrackInput& input, const StopReason& reason)
{
  if (reason && is_under_way()) brake_for(reason);
  if (rests() && measured_.usable) steering_.adopt(measured_.wheels.angle);
  if (rests() && has_next_) begin(reason);
  switch (state_)
  {
    case TrackState::aligning: return align(input);
    case TrackState::driving: return drive(input.permission);
    case TrackState::stopping: return brake();
    default: return rest();
  }
}

/// Starts the next mission, at rest.
void Sequencer::begin(const StopReason& reason)
{
  mission_.swap(next_);
  has_next_ = false;
  index_ = 0;
  corrector_.finish();
  if (reason) return enter(TrackState::failed, reason);
  if (const StopReason away = judge_start()) return enter(TrackState::failed, away);
  start_aligning();
}

/// Whether the robot rests where the mission begins.
StopReason Sequencer::judge_start() const
{
  const Pose start = mission_.front().start_pose();
  if (is_within(measured_.pose, start, options_.xy_start_tolerance, options_.yaw_start_tolerance)) return {};
  return {"the trajectory begins %.3f m and %.3f rad from the robot", distance(measured_.pose, start),
          turn_between(measured_.pose, start)};
}

/// Sets the wheels' angles for the stretch.
void Sequencer::start_aligning()
{
  const Reference& next = stretch();
  const SteeringRange range = {next.least_phi(), next.greatest_phi()};
  if (const StopReason reason = steering_.choose(next.mode(), next.start_phi(), range, measured_.wheels.angle))
    return enter(TrackState::failed, reason);
  enter(TrackState::aligning);
  aligning_sequence_ = sequence_;
  place_ = on_mission(next.start_time());
}

WheelCommand Sequencer::align(const TrackInput& input)
{
  if (is_aligned(input.wheels))
  {
    waits_for_ = reason_to_wait(input.permission);
    if (waits_for_)
    {
      elapsed_ = 0.0;  // they are aligned: this is no time that alignment takes
      return steering_.command();
    }
    enter(TrackState::driving);
    follower_.start(stretch(), steering_.range(), measured_);
    return drive(input.permission);
  }
  if (elapsed_ <= options_.alignment_timeout) return steering_.command();
  brake_for(
      {"the wheels are not aligned after %.3f s, alignment_timeout is %.3f s", elapsed_, options_.alignment_timeout});
  return brake();
}

/// Whether the wheels have the angles wanted now. `aligned` is about these angles only if the base has taken a command
/// that was sent since.
bool Sequencer::is_aligned(const WheelState& wheels) const
{
  const std::uint32_t since = sequence_ - aligning_sequence_, behind = sequence_ - wheels.sequence;
  return wheels.aligned && wheels.mode == stretch().mode() && behind > 0 && behind <= since;
}

/// Why the robot must not go on for a control step, or nothing. What has been checked is the mission, so corrections need
/// permission for all of it.
StopReason Sequencer::reason_to_wait(const DrivePermission& permission) const
{
  if (permission.age == std::numeric_limits<double>::infinity()) return {"no permission to drive has come"};
  if (!(permission.age <= options_.permit_timeout))
    return {"the permission to drive is %.3f s old, permit_timeout is %.3f s", permission.age, options_.permit_timeout};
  const double limit = permission.free_until;
  if (limit >= mission_.back().end_time()) return {};
  const bool is_beginning = state_ == TrackState::aligning;
  const double rest = is_beginning ? stretch().start_time() : follower_.rest_time(limit);
  if (!corrector_.is_active() && rest < limit) return {};
  return {"the way is known to be free until %.3f s of the trajectory", limit};
}

WheelCommand Sequencer::drive(const DrivePermission& permission)
{
  waits_for_ = reason_to_wait(permission);
  const Follower::Answer answer = follower_.step(measured_, !waits_for_);
  place_ = on_mission(follower_.clock());
  StopReason reason = answer.stop_reason ? answer.stop_reason : judge_deviation(follower_.deviation(), options_);
  if (!reason && answer.finished)
  {
    finish_stretch();
    return is_under_way() ? steering_.command() : rest();
  }
  if (!reason) reason = steering_.set(stretch().mode(), answer.command);
  if (!reason) return steering_.command();
  brake_for(reason);
  return brake();
}

/// At rest at the end of a stretch: correct, go on, or arrive.
void Sequencer::finish_stretch()
{
  const RestTarget place = rest_target();
  const double away = distance(measured_.pose, place.pose), turned = turn_between(measured_.pose, place.pose);
  const bool reached = place.is_reached(measured_.pose);
  if (!reached && !corrector_.is_near(measured_.pose, place))
    return enter(TrackState::failed,
                 {"the robot rests %.4f m and %.4f rad from where it should, too far to correct", away, turned});
  if (!reached && corrector_.start(measured_.pose, place)) return start_aligning();
  corrector_.finish();
  if (!reached && is_last())
    return enter(TrackState::failed,
                 {"the robot rests %.4f m and %.4f rad from the goal and could not get nearer", away, turned});
  if (is_last()) return enter(TrackState::arrived);
  ++index_;
  start_aligning();
}

/// The mission's time for the time t of the present stretch. During a correction it is the end of the stretch that is
/// corrected.
double Sequencer::on_mission(double t) const
{
  const Reference& driven = mission_[index_];
  return corrector_.is_active() ? driven.end_time() : std::clamp(t, driven.start_time(), driven.end_time());
}

/// Where the present stretch of the mission should end.
RestTarget Sequencer::rest_target() const
{
  const Pose& end = mission_[index_].end_pose();
  if (is_last()) return {end, options_.xy_goal_tolerance, options_.yaw_goal_tolerance};
  return {end, options_.xy_switch_tolerance, options_.yaw_switch_tolerance};
}

/// Reduces the speed along the present curve; at rest, holds the wheels.
WheelCommand Sequencer::brake()
{
  rolling_ = rolling_ && slow_down();
  if (rolling_) return steering_.command();
  const double ramp = robot_.max_speed / robot_.max_acceleration;
  if (!measured_.at_rest && elapsed_ <= ramp + kUnseenRestTime) return rest();
  if (fails_)
    enter(TrackState::failed, reason_);
  else
    enter(TrackState::idle);
  return rest();
}

/// Whether there is still something to brake.
bool Sequencer::slow_down()
{
  const ModeMotion slower = follower_.brake(measured_);
  return slower.v != 0.0 && !steering_.set(steering_.command().mode, slower);
}

/// Begins to brake: on the way to `failed` if there is a reason to stop, to `idle` if not.
void Sequencer::brake_for(const StopReason& reason)
{
  rolling_ = state_ == TrackState::driving;
  fails_ = bool(reason);
  enter(TrackState::stopping, reason ? reason : StopReason{"told to stop"});
}

void Sequencer::enter(TrackState state, const StopReason& reason)
{
  state_ = state;
  reason_ = reason;
  elapsed_ = 0.0;
}

void Sequencer::report(TrackOutput& output)
{
  // The robot may rest between a mission that was stopped and one that waits. This is not reported as the end of the
  // waiting one.
  output.state = has_next_ && rests() ? TrackState::stopping : state_;
  write(waits_for_ ? waits_for_ : reason_, message_);
  output.message = message_.data();
  if (!rests()) output.t = place_;
  if (state_ != TrackState::driving && !(state_ == TrackState::stopping && rolling_)) return;
  output.speed = follower_.asked().v;
  output.phi = follower_.asked().phi;
  output.lateral_error = follower_.deviation().lateral;
  output.longitudinal_error = follower_.deviation().longitudinal;
  output.heading_error = follower_.deviation().heading;
}

}  // namespace fourwis
