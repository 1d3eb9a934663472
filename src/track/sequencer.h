#pragma once

#include <array>
#include <optional>

#include "fourwis_navigation/track/tracker.h"
#include "correction.h"
#include "follower.h"
#include "mission.h"
#include "steering_unit.h"

namespace fourwis
{

/// What to do next, from control step to control step:
///
///   idle, arrived, failed --take()--> aligning --aligned--> driving --at rest at the stretch's end--> aligning ... arrived
///   aligning, driving --stop() or trouble--> stopping --at rest--> idle or failed
///
/// At a stretch's end too far from where it should be, a creeping correction comes first, a stretch like any other.
class Sequencer
{
public:
  Sequencer(const Robot& robot, const TrackOptions& options);

  /// Drives `mission`, not empty, once the robot is at rest; whatever it drives now it stops. The former contents are handed
  /// back, so that nothing is freed here.
  void take(Mission& mission);

  /// Brakes to rest and forgets the mission.
  void stop();

  TrackOutput step(const TrackInput& input);

  TrackState state() const { return state_; }
  const std::vector<Pose>& prediction() const { return state_ == TrackState::driving ? follower_.prediction() : none_; }

private:
  bool is_under_way() const { return state_ == TrackState::aligning || state_ == TrackState::driving; }
  const Reference& stretch() const { return correcting_ ? correction_ : mission_[index_]; }
  bool is_last() const { return index_ + 1 == mission_.size(); }

  Trouble observe(const TrackInput& input);
  WheelCommand act(const TrackInput& input, const Trouble& trouble);
  void begin(const Trouble& trouble);
  void start_aligning();
  WheelCommand align(const WheelState& wheels);
  bool is_aligned(const WheelState& wheels) const;
  WheelCommand drive();
  WheelCommand finish_stretch();
  bool is_near(const Pose& target) const;
  bool start_correction(const Pose& target);
  WheelCommand brake();
  void come_to_rest(TrackState state);
  void stop_because(const Trouble& trouble);
  void fail(const Trouble& trouble);
  void say(const Trouble& trouble);
  void report(TrackOutput& output) const;

  const Robot robot_;
  const TrackOptions options_;
  Follower follower_;
  SteeringUnit steering_;
  Measurement measured_;
  std::optional<double> last_now_;  ///< of the input

  TrackState state_ = TrackState::idle;
  TrackState after_stop_ = TrackState::idle;
  std::array<char, 160> message_{};
  bool driving_before_stop_ = false;
  double elapsed_ = 0.0;  ///< in this state [s]

  Mission mission_, next_;
  bool has_next_ = false;
  std::size_t index_ = 0;
  bool correcting_ = false;
  double corrected_ = 0.0;  ///< how long this place has been corrected for [s]
  Reference correction_;

  std::uint32_t sequence_ = 0;          ///< of the last command
  std::uint32_t aligning_sequence_ = 0;  ///< of the first that has the angles to align to
  bool numbered_ = false;               ///< whether the sequence has begun
  const std::vector<Pose> none_;
};

}  // namespace fourwis
