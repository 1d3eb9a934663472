#pragma once

#include <vector>

namespace fourwis::ocp
{

/// Where a line search started: violation theta of the equalities, barrier function phi, and its slope along the step.
struct SearchPoint
{
  double violation, barrier, slope;
};

/// Filter line search (Waechter and Biegler 2006): a step is accepted if it reduces the violation or the barrier
/// function sufficiently, and is not dominated by earlier pairs of the two.
class Filter
{
public:
  enum class Verdict
  {
    rejected,
    reduces_barrier,  ///< Armijo's condition holds where the violation is small: the filter stays as it is
    makes_progress,   ///< the starting point must be added to the filter
  };

  void reserve(std::size_t entries) { entries_.reserve(entries); }

  /// Starts anew for iterates around the given violation.
  void reset(double violation);

  /// For another barrier function the old pairs mean nothing.
  void clear() { entries_.clear(); }

  void add(double violation, double barrier);

  /// `alpha` is the length of the step tried, theta and phi what it leads to; not finite is rejected.
  Verdict judge(const SearchPoint& start, double alpha, double violation, double barrier) const;

private:
  struct Entry
  {
    double violation, barrier;
  };

  bool accepts(double violation, double barrier) const;

  std::vector<Entry> entries_;
  double greatest_violation_ = 0.0;
  double small_violation_ = 0.0;
};

}  // namespace fourwis::ocp
