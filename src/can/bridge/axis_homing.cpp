#include "axis_homing.h"

namespace fourwis::can
{
namespace
{

/// For this long after the start of a homing, the statusword may still tell of an earlier one [s].
constexpr double kStatusDelay = 0.05;
constexpr std::uint16_t kAttained = status_bit::homing_attained | status_bit::target_reached;

bool is_homing(const DriveStatus& status)
{
  return status.mode == static_cast<std::int8_t>(OperationMode::homing);
}

}  // namespace

std::uint16_t AxisHoming::bits(const DriveStatus& status, double now)
{
  if (!is_homing(status)) return 0;
  if (!running_) begun_ = now;
  running_ = true;
  return control::homing_start;
}

void AxisHoming::supervise(const DriveStatus& status, double now)
{
  if (!running_) return;
  const double elapsed = now - begun_;
  // In another mode, or before the drive has started to home, these bits of the statusword have another meaning.
  const std::uint16_t bits = is_homing(status) && elapsed > kStatusDelay ? status.statusword : 0;
  const bool error = bits & status_bit::homing_error;
  if (error || elapsed > timeout_) report_(Fault::homing_failed, status.statusword, now);
  done_ = (bits & kAttained) == kAttained && !error;
  running_ = !done_;
}

}  // namespace fourwis::can
