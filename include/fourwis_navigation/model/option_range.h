#pragma once

#include <sstream>
#include <stdexcept>

namespace fourwis
{

/// Throws std::invalid_argument naming option, value and range unless min <= value <= max; NaN never is.
inline void require_between(const char* option, double value, double min, double max)
{
  if (value >= min && value <= max) return;
  std::ostringstream text;
  text << option << " is " << value << ", expected a number from " << min << " to " << max;
  throw std::invalid_argument(text.str());
}

}  // namespace fourwis
