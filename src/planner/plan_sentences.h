#pragma once

#include <cstdio>
#include <string>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/plan.h"

namespace fourwis
{

template <typename... Numbers>
std::string sentence(const char* format, Numbers... numbers)
{
  char text[256];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

/// A result that is not a plan.
PlanResult refusal(PlanStatus status, std::string message);

/// Unusable requests by their status; `succeeded` for all others.
PlanResult refuse(const CollisionChecker& checker, const PlanRequest& request);

/// How a search that found nothing ended.
std::string search_sentence(PlanStatus status, int expansions, const PlanRequest& request);

}  // namespace fourwis
