#pragma once

#include <string>
#include <vector>

namespace fourwis
{

/// Whether there is a corridor, and if not, why.
enum class CorridorStatus
{
  succeeded,
  in_collision,  ///< the reference meets an obstacle or leaves the map: no region holds it
  invalid_input  ///< too few knots, or something is not finite
};

inline const char* to_string(CorridorStatus status)
{
  switch (status)
  {
    case CorridorStatus::succeeded: return "succeeded";
    case CorridorStatus::in_collision: return "in_collision";
    case CorridorStatus::invalid_input: return "invalid_input";
  }
  return "invalid_input";
}

/// Regions, and how well they keep their distance.
template <typename Regions>
struct CorridorResult
{
  CorridorStatus status = CorridorStatus::invalid_input;
  std::string message;          ///< why not succeeded: one sentence with numbers, for a person
  Regions regions;              ///< none unless succeeded
  std::vector<double> deficit;  ///< how much less than the wanted distance the regions of an interval or knot keep [m]
};

}  // namespace fourwis
