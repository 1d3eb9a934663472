#pragma once

#include <string>

#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/sentence.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{

/// What is to be said of a plan besides its numbers; `why` a part fell back to stops.
std::string remarks(const PlanResult& result, const std::string& why);

/// How a search that found nothing ended; `asked` is in the map frame.
std::string search_sentence(const World& world, const PlanResult& result, const PlanRequest& asked);

}  // namespace fourwis
