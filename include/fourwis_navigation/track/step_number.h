#pragma once

#include <cmath>
#include <cstdint>

namespace fourwis
{

/// How much earlier than on time a measurement may come and still belong to the control step [s].
inline constexpr double kStepJitter = 1e-3;

/// Which control step a measurement of time `now` [s] belongs to. Steps are counted from time 0, not from the start of
/// the controller. So two controllers that measure the same at the same times have the same steps with the same
/// numbers.
inline std::uint64_t step_number(double now, double controller_frequency)
{
  const double steps = (now + kStepJitter) * controller_frequency;
  return steps > 0.0 && steps < 1e18 ? static_cast<std::uint64_t>(steps) : 0;
}

}  // namespace fourwis
