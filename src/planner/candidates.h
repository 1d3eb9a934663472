#pragma once

#include <vector>

#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/search/front_end.h"
#include "fourwis_navigation/search/search_options.h"

namespace fourwis
{

/// Different ways to the same goal.
struct Candidates
{
  PlanStatus status = PlanStatus::no_path;  ///< of the first search; succeeded if there is any path
  int expansions = 0;                       ///< of all searches
  std::vector<Path> paths;                  ///< no two alike
};

/// One path after the costs as configured: what the paper's front end finds.
Candidates find_one(const FrontEnd& front_end, const SearchOptions& options, const ModeSet& modes,
                    const Interrupt& interrupt, std::vector<Pose>* expanded);

/// Paths worth optimising, searched for at the same time. The paper's costs shun steering and reversing, which the optimiser makes
/// nearly free, and switches are the dearer by comparison; which path is the fastest shows only after the optimisation. So:
/// the modes asked for and Ackermann motion alone, both after what takes time, and Ackermann motion after softened costs.
Candidates find_several(const FrontEnd& front_end, const Robot& robot, const SearchOptions& options,
                        const ModeSet& modes, const Interrupt& interrupt, std::vector<Pose>* expanded);

}  // namespace fourwis
