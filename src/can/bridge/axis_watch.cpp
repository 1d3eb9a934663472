#include "axis_watch.h"

#include <algorithm>
#include <cmath>

#include "axis_scale.h"

namespace fourwis::can
{
namespace
{

/// A drive answers each SYNC with two frames.
constexpr int kAnswers = 2;
/// The factor by which a real axis may exceed its limit of speed, and the cycles by which a measurement may be late.
constexpr double kSpeedSlack = 2.0, kLateCycles = 2.0;

}  // namespace

AxisWatch::AxisWatch(const BridgeOptions& options, double max_speed, double error, Fault not_followed,
                     FaultReporter report)
  : max_speed_(max_speed),
    error_(error),
    heartbeat_timeout_(options.heartbeat_timeout),
    cycle_time_(options.cycle_time),
    lost_after_(std::max(2, static_cast<int>(std::lround(options.feedback_timeout / options.cycle_time)))),
    most_unasked_(kAnswers * (lost_after_ + 1)),
    not_followed_(not_followed),
    report_(report),
    off_(options.following_time)
{}

void AxisWatch::begin(double now)
{
  heard_ = now;
  unanswered_status_ = unanswered_motion_ = unasked_ = 0;
  rebooted_ = false;
  position_.reset();
  off_.reset();
}

void AxisWatch::receive_heartbeat(NmtState state, double now)
{
  heard_ = now;
  if (state == NmtState::boot_up)
  {
    rebooted_ = true;
    report_(Fault::node_rebooted, 0, now);
  }
  else if (state != NmtState::operational)
    report_(Fault::node_not_operational, static_cast<std::uint32_t>(state), now);
}

void AxisWatch::receive_status(double now)
{
  count_answer(unanswered_status_, now);
}

void AxisWatch::receive_motion(std::int32_t position, double now)
{
  count_answer(unanswered_motion_, now);
  const double possible = kSpeedSlack * max_speed_ * (now - moved_ + kLateCycles * cycle_time_);
  const double moved = position_ ? counts_between(*position_, position) : 0.0;
  if (std::abs(moved) > possible) report_(Fault::encoder_jump, 0, now);
  position_ = position;
  moved_ = now;
}

void AxisWatch::sync_sent()
{
  ++unanswered_status_;
  ++unanswered_motion_;
  unasked_ = std::max(unasked_ - kAnswers, 0);
}

void AxisWatch::supervise(double now)
{
  if (now - heard_ > heartbeat_timeout_) report_(Fault::heartbeat_lost, 0, now);
  if (std::max(unanswered_status_, unanswered_motion_) >= lost_after_) report_(Fault::feedback_lost, 0, now);
}

void AxisWatch::supervise_following(double difference, double now)
{
  if (off_.update(std::abs(difference) > error_, now)) report_(not_followed_, 0, now);
}

void AxisWatch::count_answer(int& unanswered, double now)
{
  unanswered = 0;
  // Late answers may come several at once, but never more than there were SYNCs. A node that has rebooted does not
  // answer before it is started: if it does, there are two nodes.
  if (++unasked_ > most_unasked_ || rebooted_) report_(Fault::duplicate_node, 0, now);
}

}  // namespace fourwis::can
