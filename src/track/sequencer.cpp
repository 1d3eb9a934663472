#include "sequencer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fourwis
{
namespace
{

/// A robot whose wheels' state is not known counts as being at rest so long after it should be [s].
constexpr double kBlindStop = 1.0;
/// Room for a correction [points].
constexpr std::size_t kCorrectionPoints = 4096;

constexpr TrajectoryPoint kNowhere = {0.0, Mode::parallel};

}  // namespace

Sequencer::Sequencer(const Robot& robot, const TrackOptions& options)
  : robot_(robot), options_(options), follower_(robot, options), steering_(robot),
    correction_(robot, &kNowhere, &kNowhere + 1)
{
  correction_.reserve(kCorrectionPoints);
}

void Sequencer::take(Mission& mission)
{
  next_.swap(mission);
  has_next_ = true;
  if (is_under_way()) stop_because({});
}

void Sequencer::stop()
{
  has_next_ = false;
  if (is_under_way()) stop_because({});
  if (state_ == TrackState::arrived || state_ == TrackState::failed) come_to_rest(TrackState::idle);
}

TrackOutput Sequencer::step(const TrackInput& input)
{
  const Trouble trouble = observe(input);
  elapsed_ += measured_.period;
  TrackOutput output;
  output.command = act(input, trouble);
  output.command.sequence = ++sequence_;
  report(output);
  return output;
}

/// Takes over what was measured, as far as it is good for anything, and says what is wrong with it.
Trouble Sequencer::observe(const TrackInput& input)
{
  const double period = last_now_ && std::isfinite(input.now) ? input.now - *last_now_ : 0.0;
  if (std::isfinite(input.now)) last_now_ = input.now;
  const bool regular = period >= 0.0 && period <= options_.step_timeout;
  measured_.period = regular ? period : 0.0;
  measured_.now += measured_.period;
  if (!numbered_) sequence_ = input.wheels.sequence;
  numbered_ = true;

  Trouble trouble = judge_input(input, options_);
  if (!trouble && !regular)
    trouble = {"the clock went on by %.3f s in one control step, step_timeout is %.3f s", period, options_.step_timeout};
  measured_.at_rest = false;
  if (trouble) return trouble;
  measured_.pose = input.pose;
  measured_.pose_stamp = measured_.now - (input.now - input.pose_stamp);
  measured_.wheels = input.wheels.motion;
  measured_.wheel_stamp = measured_.now - (input.now - input.wheels.stamp);
  measured_.at_rest = is_at_rest(input.wheels, options_);
  if (!is_under_way() && state_ != TrackState::stopping) steering_.adopt(input.wheels.motion.angle);
  return {};
}

WheelCommand Sequencer::act(const TrackInput& input, const Trouble& trouble)
{
  if (trouble && is_under_way()) stop_because(trouble);
  if (has_next_ && !is_under_way() && state_ != TrackState::stopping) begin(trouble);
  switch (state_)
  {
    case TrackState::aligning: return align(input.wheels);
    case TrackState::driving: return drive();
    case TrackState::stopping: return brake();
    default: return steering_.hold();
  }
}

/// Starts the next mission, at rest.
void Sequencer::begin(const Trouble& trouble)
{
  mission_.swap(next_);
  has_next_ = false;
  index_ = 0;
  correcting_ = false;
  corrected_ = 0.0;
  if (trouble) return fail(trouble);
  const Pose& start = mission_.front().start_pose();
  const double away = distance(measured_.pose, start), turned = std::abs(wrap_angle(measured_.pose.theta - start.theta));
  if (away > options_.max_lateral_error || turned > options_.max_heading_error)
    return fail({"the trajectory begins %.3f m and %.3f rad from the robot", away, turned});
  start_aligning();
}

/// Sets the wheels' angles for the stretch.
void Sequencer::start_aligning()
{
  const Reference& next = stretch();
  const Trouble trouble = steering_.choose(next.mode(), next.start_phi(), {next.least_phi(), next.greatest_phi()},
                                           measured_.wheels.angle);
  if (trouble) return fail(trouble);
  state_ = TrackState::aligning;
  elapsed_ = 0.0;
  aligning_sequence_ = sequence_ + 1;
  message_[0] = '\0';
}

/// Whether `aligned` is about a command with the present angles: the base has taken one that was sent since.
bool Sequencer::is_aligned(const WheelState& wheels) const
{
  const std::uint32_t behind = sequence_ - wheels.sequence, since = sequence_ - aligning_sequence_;
  return sequence_ + 1 != aligning_sequence_ && behind <= since && wheels.mode == steering_.command().mode &&
         wheels.aligned;
}

WheelCommand Sequencer::align(const WheelState& wheels)
{
  if (is_aligned(wheels))
  {
    state_ = TrackState::driving;
    elapsed_ = 0.0;
    follower_.start(stretch(), steering_.range(), measured_);
    return drive();
  }
  if (elapsed_ > options_.alignment_timeout)
  {
    stop_because({"the wheels are not aligned after %.3f s, alignment_timeout is %.3f s", elapsed_,
                  options_.alignment_timeout});
    return brake();
  }
  return steering_.command();
}

WheelCommand Sequencer::drive()
{
  const Follower::Answer answer = follower_.step(measured_);
  Trouble trouble = answer.trouble ? answer.trouble : judge_deviation(follower_.deviation(), options_);
  if (!trouble && answer.finished) return finish_stretch();
  if (!trouble) trouble = steering_.set(stretch().mode(), answer.command);
  if (!trouble) return steering_.command();
  stop_because(trouble);
  return brake();
}

/// At rest at the end of a stretch: correct, go on, or arrive.
WheelCommand Sequencer::finish_stretch()
{
  const Pose target = mission_[index_].end_pose();
  if (!is_near(target))
  {
    if (start_correction(target)) return steering_.command();
    if (is_under_way() && is_last())
      fail({"the robot rests %.4f m and %.4f rad from the goal, which is beyond the tolerances",
            distance(measured_.pose, target), std::abs(wrap_angle(measured_.pose.theta - target.theta))});
    if (!is_under_way()) return steering_.hold();
  }
  correcting_ = false;
  corrected_ = 0.0;
  if (is_last())
    come_to_rest(TrackState::arrived);
  else
  {
    ++index_;
    start_aligning();
  }
  return is_under_way() ? steering_.command() : steering_.hold();
}

bool Sequencer::is_near(const Pose& target) const
{
  const double xy = is_last() ? options_.xy_goal_tolerance : options_.xy_switch_tolerance;
  const double yaw = is_last() ? options_.yaw_goal_tolerance : options_.yaw_switch_tolerance;
  return distance(measured_.pose, target) <= xy && std::abs(wrap_angle(measured_.pose.theta - target.theta)) <= yaw;
}

/// First the heading, then the place. False when the time for it is over.
bool Sequencer::start_correction(const Pose& target)
{
  if (corrected_ > options_.correction_timeout) return false;
  const double turn = wrap_angle(target.theta - measured_.pose.theta);
  const Creep creep = std::abs(turn) > options_.yaw_goal_tolerance
                        ? creeping_turn(robot_, measured_.pose, turn, options_.correction_speed)
                        : creeping_shift(measured_.pose, target, options_.correction_speed);
  correction_.assign(creep.data(), creep.data() + creep.size());
  correcting_ = true;
  start_aligning();
  return is_under_way();
}

/// Reduces the speed along the present curve; at rest, holds the wheels.
WheelCommand Sequencer::brake()
{
  const ModeMotion motion = follower_.brake(measured_);
  const bool ramped = motion.v == 0.0 || !driving_before_stop_;
  if (ramped && (measured_.at_rest || elapsed_ > kBlindStop + robot_.max_speed / robot_.max_acceleration))
  {
    come_to_rest(after_stop_);
    return steering_.hold();
  }
  if (ramped || steering_.set(steering_.command().mode, motion)) return steering_.hold();
  return steering_.command();
}

/// Begins to brake: on the way to `failed` because of trouble, to `idle` without.
void Sequencer::stop_because(const Trouble& trouble)
{
  driving_before_stop_ = state_ == TrackState::driving;
  state_ = TrackState::stopping;
  elapsed_ = 0.0;
  after_stop_ = trouble ? TrackState::failed : TrackState::idle;
  say(trouble);
}

void Sequencer::come_to_rest(TrackState state)
{
  state_ = state;
  elapsed_ = 0.0;
  if (state != TrackState::failed) message_[0] = '\0';
}

void Sequencer::fail(const Trouble& trouble)
{
  come_to_rest(TrackState::failed);
  say(trouble);
}

void Sequencer::say(const Trouble& trouble)
{
  message_[0] = '\0';
  if (trouble) std::snprintf(message_.data(), message_.size(), trouble.format, trouble.first, trouble.second);
}

void Sequencer::report(TrackOutput& output) const
{
  output.state = state_;
  output.message = message_.data();
  if (!is_under_way() && state_ != TrackState::stopping) return;
  output.speed = follower_.asked().v;
  output.phi = follower_.asked().phi;
  if (state_ == TrackState::aligning) return;
  output.t = follower_.clock();
  output.lateral_error = follower_.deviation().lateral;
  output.longitudinal_error = follower_.deviation().longitudinal;
  output.heading_error = follower_.deviation().heading;
}

}  // namespace fourwis
