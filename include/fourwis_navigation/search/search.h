#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "fourwis_navigation/search/hybrid_astar.h"
#include "fourwis_navigation/search/search_problem.h"

namespace fourwis
{

/// How hard a search tries.
enum class Effort
{
  quick,      ///< a coarse search of a few thousand expansions
  both_ways,  ///< another one from the goal to the start where that finds nothing
  thorough    ///< a finer one, guided by the headings at which the body fits, after a proof of unreachability was tried
};

class DirectedSearch;

/// The front end, the paper's section III-A, for one start and goal. The distance to the goal and the proof of
/// unreachability are computed once. Then any number of searches with different modes and costs may be made, also at
/// the same time from several threads.
class Search
{
public:
  explicit Search(const SearchProblem& problem);
  ~Search();

  /// 4D Hybrid A* and shortcuts. Poses expanded are appended to `expanded` where it is not null. Throws as check(options)
  /// does.
  SearchResult find(const SearchOptions& options, const ModeSet& modes, Effort effort = Effort::thorough,
                    std::vector<Pose>* expanded = nullptr) const;

private:
  const DirectedSearch& backward() const;
  bool is_proven_unreachable() const;
  SearchResult find_quickly(SearchOptions options, const ModeSet& modes, Effort effort,
                            std::vector<Pose>* expanded) const;
  SearchResult find_thoroughly(SearchOptions options, const ModeSet& modes, std::vector<Pose>* expanded) const;
  Path shortened(const SearchOptions& options, const ModeSet& modes, Path path) const;

  const SearchProblem problem_;
  const std::unique_ptr<const DirectedSearch> forward_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const DirectedSearch> backward_;
};

/// Whether the modes can bring the robot to the goal's heading: parallel motion alone does not turn.
bool may_turn(const Pose& start, const Pose& goal, const ModeSet& modes);

}  // namespace fourwis
