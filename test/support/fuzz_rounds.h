#pragma once

#include <algorithm>
#include <cstdlib>

namespace fourwis
{

/// How many rounds a fuzz loop takes: `usual`, or that times the environment's FOURWIS_FUZZ_FACTOR (scripts/nightly.sh).
inline int fuzz_rounds(int usual)
{
  const char* factor = std::getenv("FOURWIS_FUZZ_FACTOR");
  return factor ? usual * std::max(1, std::atoi(factor)) : usual;
}

}  // namespace fourwis
