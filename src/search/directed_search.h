#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "fourwis_navigation/search/hybrid_astar.h"
#include "fourwis_navigation/search/search_problem.h"
#include "goal_distance.h"
#include "holonomic_distance.h"

namespace fourwis
{

/// Searches from the start towards the goal, with what guides them. May be used from several threads.
class DirectedSearch
{
public:
  explicit DirectedSearch(const SearchProblem& problem);

  const GoalDistance& distance() const { return distance_; }

  /// What guides thorough searches; computed when first asked for, which takes tens of milliseconds.
  const HolonomicDistance& holonomic_distance() const;

  /// Between the points of the lattice of poses that holonomic_distance() is made of [m].
  double lattice_spacing() const;

  /// Guided by the distance around obstacles.
  SearchResult quick(const SearchOptions& options, const ModeSet& modes, std::vector<Pose>* expanded) const;

  /// Guided by the headings at which the body fits.
  SearchResult guided(const SearchOptions& options, const ModeSet& modes, std::vector<Pose>* expanded) const;

private:
  const SearchProblem problem_;
  const GoalDistance distance_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const HolonomicDistance> holonomic_distance_;
};

}  // namespace fourwis
