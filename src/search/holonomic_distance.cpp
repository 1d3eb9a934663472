#include "fourwis_navigation/search/holonomic_distance.h"

#include <algorithm>
#include <limits>

#include "free_headings.h"

namespace fourwis
{
namespace
{

constexpr std::uint16_t kUnseen = std::numeric_limits<std::uint16_t>::max();

/// Headings of one cell that the last step reached for the first time.
struct Wave
{
  int cell;
  HeadingSet headings;
};

}  // namespace

HolonomicDistance::HolonomicDistance(const SearchProblem& problem, double cell_size, double slack)
  : cells_(problem.checker.map(), cell_size),
    steps_(cells_.count() * kHeadings, kUnseen)
{
  const Pose &start = problem.start, &goal = problem.goal;
  FreeHeadings free(problem.checker, cells_);
  std::vector<HeadingSet> reached(cells_.count(), 0);
  std::vector<Wave> wave, next;
  const auto reach = [&](int cell, HeadingSet headings, int step) {
    const HeadingSet fresh = headings & ~reached[static_cast<std::size_t>(cell)];
    if (fresh == 0) return;
    reached[static_cast<std::size_t>(cell)] |= fresh;
    next.push_back({cell, fresh});
    for (int k = 0; k < kHeadings; ++k)
      if (fresh >> k & 1u) steps_[state(cell, k)] = static_cast<std::uint16_t>(step);
  };

  const HeadingSet goal_headings = HeadingSet{1} << heading_bin(goal.theta);
  const HeadingSet start_headings = HeadingSet{1} << heading_bin(start.theta);
  const std::size_t start_cell = static_cast<std::size_t>(cells_.index(start.x, start.y));
  reach(cells_.index(goal.x, goal.y), goal_headings | turned_by_one_bin(goal_headings), 0);
  int last_step = kUnseen - 1;
  for (int step = 1; !next.empty() && step <= last_step; ++step)
  {
    if (problem.interrupt.cancelled() || problem.interrupt.timed_out()) break;
    wave.swap(next);
    next.clear();
    for (const Wave& from : wave)
    {
      reach(from.cell, turned_by_one_bin(from.headings) & free[from.cell], step);
      // Four neighbours in one step, eight in the next: an octagon is nearly a circle.
      cells_.for_neighbours(from.cell, [&](int cell, bool diagonal) {
        if (!diagonal || step % 2 == 0) reach(cell, from.headings & free[cell], step);
      });
    }
    edge_ = step;
    if (!reaches_start_ && (reached[start_cell] & (start_headings | turned_by_one_bin(start_headings))))
    {
      reaches_start_ = true;
      last_step = std::min(last_step, step + static_cast<int>(slack / cell_size));
    }
  }
  reaches_start_ = reaches_start_ || !next.empty();  // a field that ended early proves nothing
}

std::size_t HolonomicDistance::state(int cell, int heading) const
{
  return static_cast<std::size_t>(cell) * kHeadings + static_cast<std::size_t>(heading);
}

double HolonomicDistance::operator()(const Pose& pose) const
{
  const std::uint16_t steps = steps_[state(cells_.index(pose.x, pose.y), heading_bin(pose.theta))];
  return cells_.size() * std::min<int>(steps, edge_ + 1);
}

}  // namespace fourwis
