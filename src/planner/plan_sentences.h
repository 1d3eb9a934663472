#pragma once

#include <string>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{

/// A result that is not a plan: the status says of which kind, the message why.
PlanResult refusal(PlanStatus status, std::string message);

/// A refusal for a request that cannot be planned for; `succeeded` for all others.
PlanResult check_request(const CollisionChecker& checker, const PlanRequest& request);

/// How a search that found nothing ended.
std::string search_sentence(PlanStatus status, int expansions, const PlanRequest& request);

}  // namespace fourwis
