#include "fourwis_navigation/sim/actuator.h"

#include <algorithm>
#include <cmath>

namespace fourwis
{

void Actuator::set_value(double value)
{
  value_ = std::clamp(value, -limits_.range, limits_.range);
}

void Actuator::step(double duration)
{
  const double share = limits_.lag > 0.0 ? -std::expm1(-duration / limits_.lag) : 1.0;
  const double most = limits_.rate * duration;
  set_value(value_ + std::clamp((target_ - value_) * share, -most, most));
}

}  // namespace fourwis
