#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fourwis_navigation/corridor/corridor_result.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{

/// A result that is no corridor: the status says of which kind, the message why.
template <typename Regions>
CorridorResult<Regions> no_corridor(CorridorStatus status, std::string message)
{
  CorridorResult<Regions> result;
  result.status = status;
  result.message = std::move(message);
  return result;
}

/// What is wrong with the knots; empty if they are valid.
inline std::string complaint(const std::vector<Pose>& knots)
{
  if (knots.size() < 2) return sentence("the reference has %zu knots, expected at least 2", knots.size());
  for (std::size_t i = 0; i < knots.size(); ++i)
    if (!is_finite(knots[i])) return sentence("knot %zu is not finite", i);
  return {};
}

}  // namespace fourwis
