#pragma once

#include <vector>

#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/search/search.h"
#include "fourwis_navigation/search/search_options.h"
#include "thread_budget.h"

namespace fourwis
{

/// One way to search.
struct SearchVariant
{
  ModeSet modes;
  SearchOptions options;
  Effort effort = Effort::thorough;
};

/// Different ways to the same goal.
struct Candidates
{
  PlanStatus status = PlanStatus::no_path;  ///< of the first search; succeeded if there is any path
  int expansions = 0;                       ///< of all searches
  std::vector<Path> paths;                  ///< no two alike
};

/// The searches for paths that are worth optimising. The paper's costs penalise steering and reversing, which take
/// nearly no time after the optimisation. Switches do take time. Which path is the fastest is known only after the
/// optimisation. So there are several searches: with the requested modes and with Ackermann motion alone, both by costs
/// that stand for time, and with Ackermann motion by softened costs.
std::vector<SearchVariant> variants_by_time(const Robot& robot, const SearchOptions& options, const ModeSet& modes);

/// What they find, searching at the same time. Poses that the first expands are appended to `expanded` where it is not
/// null.
Candidates find_candidates(const Search& search, const std::vector<SearchVariant>& variants, ThreadBudget& threads,
                           std::vector<Pose>* expanded = nullptr);

}  // namespace fourwis
