#pragma once

#include "corrector.h"
#include "follower.h"
#include "fourwis_navigation/track/tracker.h"
#include "mission.h"
#include "observer.h"
#include "steering_unit.h"

namespace fourwis
{

/// What to do next, from control step to control step:
///
///   idle, arrived, failed --take()--> aligning --aligned--> driving --at rest at the stretch's end--> aligning ...
///   arrived aligning, driving --stop() or a reason to stop--> stopping --at rest--> idle or failed
///
/// Without permission, or before the end of what is permitted, it comes to rest while driving, and is not aligned.
///
/// If the robot ends a stretch too far from where it should be, a creeping correction comes first. It is driven like a
/// stretch.
class Sequencer
{
public:
  Sequencer(const Robot& robot, const TrackOptions& options);

  /// Drives `mission`, which is not empty, once the robot is at rest. A mission that is being driven is stopped. A
  /// mission that was waiting is handed back in exchange.
  void take(Mission& mission);

  /// Brakes to rest and forgets all missions.
  void stop();

  TrackOutput step(const TrackInput& input);

  /// Empty unless driving.
  const std::vector<Pose>& prediction() const { return state_ == TrackState::driving ? follower_.prediction() : none_; }

private:
  bool is_under_way() const { return state_ == TrackState::aligning || state_ == TrackState::driving; }
  bool rests() const { return !is_under_way() && state_ != TrackState::stopping; }
  bool is_last() const { return index_ + 1 == mission_.size(); }
  const Reference& stretch() const { return corrector_.is_active() ? corrector_.stretch() : mission_[index_]; }
  RestTarget rest_target() const;
  StopReason judge_start() const;
  double on_mission(double t) const;

  // These change the state.
  void begin(const StopReason& reason);
  void start_aligning();
  void finish_stretch();
  bool slow_down();
  void brake_for(const StopReason& reason);
  void enter(TrackState state, const StopReason& reason = {});

  // These are the states.
  WheelCommand act(const TrackInput& input, const StopReason& reason);
  WheelCommand align(const TrackInput& input);
  WheelCommand drive(const DrivePermission& permission);
  WheelCommand brake();
  WheelCommand rest() const { return steering_.hold(); }

  bool is_aligned(const WheelState& wheels) const;
  StopReason reason_to_wait(const DrivePermission& permission) const;
  void report(TrackOutput& output);
  void number(double now);

  const Robot robot_;
  const TrackOptions options_;
  Observer observer_;
  Follower follower_;
  SteeringUnit steering_;
  Corrector corrector_;
  const Measurement& measured_;

  TrackState state_ = TrackState::idle;
  StopReason reason_;     ///< why it is in the state, if there is something to report
  StopReason waits_for_;  ///< why it does not go on with the mission, if it does not
  double elapsed_ = 0.0;  ///< time in the state [s]
  bool fails_ = false;    ///< whether braking ends in `failed` or in `idle`
  bool rolling_ = false;  ///< whether there is anything to brake
  Sentence message_{};

  Mission mission_, next_;
  bool has_next_ = false;
  std::size_t index_ = 0;  ///< of the stretch within the mission
  double place_ = 0.0;     ///< where on the mission the robot should be [s]

  bool numbered_ = false;                ///< whether the sequence has begun
  std::uint32_t sequence_ = 0;           ///< of this step's command
  std::uint32_t aligning_sequence_ = 0;  ///< of the first command with the angles to align to
  const std::vector<Pose> none_;
};

}  // namespace fourwis
