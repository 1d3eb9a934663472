#include "axis_homing.h"

namespace fourwis::can
{
namespace
{

/// What the statusword says of homing may be from an earlier one until the drive has seen the start [s].
constexpr double kOldNews = 0.05;
constexpr std::uint16_t kAttained = status_bit::homing_attained | status_bit::target_reached;

}  // namespace

std::uint16_t AxisHoming::update(const DriveStatus& status, double now)
{
  // Until the drive is in homing mode, these bits of its statusword mean something else.
  if (status.mode != static_cast<std::int8_t>(OperationMode::homing)) return 0;
  if (!running_)
  {
    running_ = true;
    begun_ = now;
    return control::homing_start;
  }
  const double elapsed = now - begun_;
  const bool error = status.statusword & status_bit::homing_error && elapsed > kOldNews;
  if (error || elapsed > timeout_) report_(Fault::homing_failed, status.statusword, now);
  done_ = (status.statusword & kAttained) == kAttained && !error && elapsed > kOldNews;
  running_ = !done_;
  return done_ ? 0 : control::homing_start;
}

}  // namespace fourwis::can
