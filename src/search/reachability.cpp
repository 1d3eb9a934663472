#include "reachability.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "configuration_space.h"
#include "pose_boxes.h"

namespace fourwis
{
namespace
{

constexpr int kInterruptInterval = 256;  ///< boxes visited between two looks at the interrupt
/// What a metre through a mixed box costs: a chain goes round by so much rather than through.
constexpr double kMixedCost = 3.0;
/// The proof is given up after so many visits of boxes, which take about a second.
constexpr int kMostVisits = 1'000'000;

bool is_over(const Interrupt& interrupt)
{
  return interrupt.cancelled() || interrupt.timed_out();
}

/// Whether a flood from the start through all that may be free around the points of a lattice reaches the goal.
bool flood_reaches_goal(const SearchProblem& problem, double spacing)
{
  const ObstacleMap& map = problem.checker.map();
  const HeadingSlices free = possibly_free_headings(problem.checker, spacing, problem.interrupt);
  std::vector<HeadingSet> reached(static_cast<std::size_t>(free.columns()) * static_cast<std::size_t>(free.rows()), 0);
  std::vector<std::pair<int, int>> front;
  const auto reached_at = [&](int i, int j) -> HeadingSet& {
    return reached[static_cast<std::size_t>(j) * static_cast<std::size_t>(free.columns()) +
                   static_cast<std::size_t>(i)];
  };
  const auto reach = [&](int i, int j, HeadingSet headings) {
    if (i < 0 || j < 0 || i >= free.columns() || j >= free.rows()) return;
    HeadingSet& known = reached_at(i, j);
    HeadingSet all = known | headings;
    if (all == known) return;
    for (HeadingSet next = 0; next != all; all |= turned_by_one_bin(all) & free.at(i, j)) next = all;
    known = all;
    front.emplace_back(i, j);
  };
  const auto point_of = [&](const Pose& pose) {
    const Pose in_grid = relative_to(map.origin(), pose);
    return std::pair<int, int>(std::lround(in_grid.x / spacing), std::lround(in_grid.y / spacing));
  };
  const auto start = point_of(problem.start), goal = point_of(problem.goal);
  const HeadingSet first = heading_bit(heading_bin(problem.start.theta));
  const HeadingSet last = heading_bit(heading_bin(problem.goal.theta));
  reach(start.first, start.second, first | turned_by_one_bin(first));
  const auto has_reached_goal = [&] {
    return (reached_at(goal.first, goal.second) & (last | turned_by_one_bin(last))) != 0;
  };
  for (int steps = 0; !front.empty() && !has_reached_goal(); ++steps)
  {
    if (steps % kInterruptInterval == 0 && is_over(problem.interrupt)) return true;
    const auto [i, j] = front.back();
    front.pop_back();
    const HeadingSet here = reached_at(i, j);
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di) reach(i + di, j + dj, here & free.at(i + di, j + dj));
  }
  return has_reached_goal() || is_over(problem.interrupt);
}

/// Looks for chains of boxes that are not blocked.
class Chains
{
public:
  Chains(PoseBoxes& boxes, const SearchProblem& problem, const GoalDistance& distance)
    : boxes_(boxes),
      problem_(problem),
      distance_(distance)
  {}

  bool gave_up() const { return gave_up_; }

  /// The cheapest from start to goal, without an order; empty where there is none.
  std::vector<PoseBox> cheapest()
  {
    visits_.clear();
    queue_ = {};
    const PoseBox start = boxes_.at(problem_.start), goal = boxes_.at(problem_.goal);
    reach(start, start, 0.0);
    while (!queue_.empty())
    {
      const Entry entry = queue_.top();
      queue_.pop();
      Visit& visit = visits_[PoseBoxes::key(entry.box)];
      if (visit.done) continue;
      visit.done = true;
      const double cost = visit.cost;
      if (entry.box == goal) return chain(start, goal);
      if (++count_ >= kMostVisits || (count_ % kInterruptInterval == 0 && is_over(problem_.interrupt)))
      {
        gave_up_ = true;
        return {};
      }
      boxes_.neighbours(entry.box, neighbours_);
      for (const PoseBox& next : neighbours_)
      {
        const PoseBoxes::State state = boxes_.state(next);
        if (state == PoseBoxes::State::blocked && !(next == goal)) continue;
        const double width = (boxes_.width(entry.box) + boxes_.width(next)) / 2.0;
        reach(next, entry.box, cost + (state == PoseBoxes::State::mixed ? kMixedCost : 1.0) * width);
      }
    }
    return {};
  }

private:
  struct Entry
  {
    double f;
    PoseBox box;
    bool operator<(const Entry& other) const { return f > other.f; }
  };
  struct Visit
  {
    double cost = 0.0;
    PoseBox from;
    bool known = false, done = false;
  };

  void reach(const PoseBox& box, const PoseBox& from, double cost)
  {
    Visit& visit = visits_[PoseBoxes::key(box)];
    if (visit.done || (visit.known && visit.cost <= cost)) return;
    visit = {cost, from, true, false};
    const Pose centre = boxes_.centre(box);
    queue_.push({cost + distance_(centre.x, centre.y), box});
  }

  std::vector<PoseBox> chain(const PoseBox& start, PoseBox box)
  {
    std::vector<PoseBox> boxes = {box};
    while (!(box == start))
    {
      box = visits_[PoseBoxes::key(box)].from;
      boxes.push_back(box);
    }
    return boxes;
  }

  PoseBoxes& boxes_;
  const SearchProblem& problem_;
  const GoalDistance& distance_;
  std::unordered_map<std::uint64_t, Visit> visits_;
  std::priority_queue<Entry> queue_;
  std::vector<PoseBox> neighbours_;
  int count_ = 0;
  bool gave_up_ = false;
};

}  // namespace

bool may_be_reachable(const SearchProblem& problem, const GoalDistance& distance, double spacing)
{
  if (!flood_reaches_goal(problem, spacing)) return false;
  PoseBoxes boxes(problem.checker);
  Chains chains(boxes, problem, distance);
  for (;;)
  {
    const std::vector<PoseBox> chain = chains.cheapest();
    if (chain.empty()) return chains.gave_up();
    bool finer = false;
    for (const PoseBox& box : chain)
    {
      if (boxes.state(box) == PoseBoxes::State::free || box.level + 1 == PoseBoxes::kLevels) continue;
      boxes.split(box);
      finer = true;
    }
    if (!finer) return true;
  }
}

}  // namespace fourwis
