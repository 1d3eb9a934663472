#pragma once

#include <string>
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
  std::string name;
  ModeSet modes;
  SearchOptions options;
};

/// What one of them found.
struct Candidate
{
  std::string name;
  Path path;
};

/// Different ways to the same goal.
struct Candidates
{
  PlanStatus status = PlanStatus::no_path;  ///< of the first search; succeeded if there is any path
  int expansions = 0;                       ///< of all searches
  std::vector<Candidate> candidates;        ///< no two paths alike
};

/// The searches for paths that are worth optimising. The paper's costs penalise steering and reversing, which take
/// nearly no time after the optimisation. Switches do take time. Which path is the fastest is known only after the
/// optimisation. So there are several searches: with the requested modes and with each choice of fewer of them, by costs
/// that stand for time, and with Ackermann motion by softened costs. The searches with few modes give up soon, but for
/// Ackermann motion; with more effort than a quick search they are left out.
std::vector<SearchVariant> variants_by_time(const Robot& robot, const SearchOptions& options, const ModeSet& modes,
                                            Effort effort);

/// Whether a robot that goes at the reference speed needs a way longer than its own size to steer from one lock to the other.
/// Between curves at full lock it has to stop then: no other motion leads to the same place.
bool steers_slowly(const Robot& robot, const SearchOptions& options);

/// The same robot with curves so wide that they can be joined while it moves.
Robot with_wide_curves(Robot robot);

/// What they find, with a quick search for each at the same time. With more effort the first variant is searched with first, in
/// both directions; the others follow where it finds something, and where it does not, a thorough search with it. Poses that
/// the first expands are appended to `expanded` where it is not null.
Candidates find_candidates(const Search& search, const std::vector<SearchVariant>& variants, Effort effort,
                           ThreadBudget& threads, std::vector<Pose>* expanded = nullptr);

/// Least time of a trajectory along a path whose switches stay where they are [s]: from rest to rest straight from one to the
/// next, and the switches.
double least_time(const Robot& robot, const Path& path);

/// Adds what another search found.
void add(Candidates&& more, Candidates& found);

}  // namespace fourwis
