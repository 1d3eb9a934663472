#pragma once

#include <cmath>
#include <cstdint>

namespace fourwis
{

/// How much earlier than on time a measurement may come and still belong to the control step [s].
inline constexpr double kStepJitter = 1e-3;

/// Which control step a measurement of time `now` [s] belongs to. They are counted from time 0, not from when the controller
/// started: whoever measures the same at the same times controls at the same steps, and says the same of them.
inline std::uint64_t step_number(double now, double controller_frequency)
{
  const double steps = (now + kStepJitter) * controller_frequency;
  return steps > 0.0 && steps < 1e18 ? static_cast<std::uint64_t>(steps) : 0;
}

}  // namespace fourwis
