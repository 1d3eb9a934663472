#pragma once

#include <sstream>

#include "conversions.h"

namespace fourwis
{

/// Throws a ConversionError that says the parts one after the other.
template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  throw ConversionError(text.str());
}

}  // namespace fourwis
