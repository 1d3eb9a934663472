#include "holonomic_distance.h"

#include <algorithm>
#include <limits>

#include "configuration_space.h"

namespace fourwis
{
namespace
{

/// Turning by one heading takes as many steps: without a turn in place a robot has to shunt.
constexpr int kTurnSteps = 3;
constexpr std::uint16_t kUnseen = std::numeric_limits<std::uint16_t>::max();

/// Headings of one cell that the last step reached for the first time.
struct Wave
{
  int cell;
  HeadingSet headings;
};

}  // namespace

HolonomicDistance::HolonomicDistance(const SearchProblem& problem, double spacing, double slack)
  : map_(problem.checker.map()),
    points_(free_headings(problem.checker, spacing, problem.interrupt)),
    cells_(map_, 2.0 * spacing),
    steps_(cells_.count() * kHeadings, kUnseen)
{
  const Pose &start = problem.start, &goal = problem.goal;
  std::vector<HeadingSet> free(cells_.count()), reached(cells_.count(), 0);
  for (int cell = 0; cell < static_cast<int>(cells_.count()); ++cell)
    for (const auto& [i, j] : points_of(cell)) free[static_cast<std::size_t>(cell)] |= points_.at(i, j);
  std::vector<std::vector<Wave>> waves(std::size_t{kTurnSteps} + 1);  // of the last steps
  const auto wave_of = [&](int step) -> std::vector<Wave>& {
    return waves[static_cast<std::size_t>(step) % waves.size()];
  };
  const auto reach = [&](int cell, HeadingSet headings, int step) {
    const HeadingSet fresh = headings & ~reached[static_cast<std::size_t>(cell)];
    if (fresh == 0) return;
    reached[static_cast<std::size_t>(cell)] |= fresh;
    wave_of(step).push_back({cell, fresh});
    for (HeadingSet rest = fresh; rest != 0; rest &= rest - 1)
      steps_[state(cell, __builtin_ctzll(rest))] = static_cast<std::uint16_t>(step);
  };

  const HeadingSet goal_headings = heading_bit(heading_bin(goal.theta));
  const HeadingSet start_headings = heading_bit(heading_bin(start.theta));
  const HeadingSet wanted = start_headings | turned_by_one_bin(start_headings);
  const int start_cell = cells_.index(start.x, start.y);
  cells_.for_square(cells_.index(goal.x, goal.y), 1,
                    [&](int cell) { reach(cell, goal_headings | turned_by_one_bin(goal_headings), 0); });
  int last_step = kUnseen - 1;
  bool exhausted = false;
  for (int step = 1; !exhausted && step <= last_step; ++step)
  {
    if (problem.interrupt.cancelled() || problem.interrupt.timed_out()) break;
    wave_of(step).clear();
    for (const Wave& from : wave_of(step - 1))
      // Four neighbours in one step, eight in the next: an octagon is nearly a circle.
      cells_.for_neighbours(from.cell, [&](int cell, bool diagonal) {
        if (!diagonal || step % 2 == 0) reach(cell, from.headings & free[static_cast<std::size_t>(cell)], step);
      });
    if (step >= kTurnSteps)
      for (const Wave& from : wave_of(step - kTurnSteps))
        reach(from.cell, turned_by_one_bin(from.headings) & free[static_cast<std::size_t>(from.cell)], step);
    edge_ = step;
    exhausted = std::all_of(waves.begin(), waves.end(), [](const std::vector<Wave>& wave) { return wave.empty(); });
    if (!reaches_start_)
      cells_.for_square(start_cell, 1, [&](int cell) {
        if (reached[static_cast<std::size_t>(cell)] & wanted) reaches_start_ = true;
      });
    if (reaches_start_ && last_step == kUnseen - 1)
      last_step = std::min(last_step, step + static_cast<int>(slack / cells_.size()));
  }
  reaches_start_ = reaches_start_ || !exhausted;  // a field that ended early proves nothing
}

std::array<std::pair<int, int>, 4> HolonomicDistance::points_of(int cell) const
{
  const int i = 2 * (cell % cells_.width()), j = 2 * (cell / cells_.width());
  return {{{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}}};
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

/// Of the points of a cell at which the body is free, the nearest to a pose.
Pose HolonomicDistance::free_point(int cell, int heading, const Pose& near) const
{
  Pose best = cells_.centre(cell);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [i, j] : points_of(cell))
  {
    if (!(points_.at(i, j) & heading_bit(heading))) continue;
    const Pose point = compose(map_.origin(), {i * points_.spacing(), j * points_.spacing(), 0.0});
    const double gap = distance(point, near);
    if (gap >= least) continue;
    least = gap;
    best = point;
  }
  best.theta = near.theta;
  return best;
}

void HolonomicDistance::way_ahead(const Pose& pose, std::vector<Pose>& points) const
{
  points.clear();
  const int heading = heading_bin(pose.theta);
  int here = cells_.index(pose.x, pose.y);
  for (;;)
  {
    int best = here;
    std::uint16_t least = steps_[state(here, heading)];
    cells_.for_neighbours(here, [&](int cell, bool) {
      const std::uint16_t steps = steps_[state(cell, heading)];
      if (steps >= least) return;
      least = steps;
      best = cell;
    });
    if (best == here) return;
    here = best;
    points.push_back(free_point(here, heading, points.empty() ? pose : points.back()));
  }
}

}  // namespace fourwis
