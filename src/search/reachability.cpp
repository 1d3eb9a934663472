#include "reachability.h"

#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "free_headings.h"

namespace fourwis
{
namespace
{

constexpr int kInterruptInterval = 128;  ///< cells flooded between two looks at the interrupt
constexpr double kSquaresPerCell = 4.0;  ///< along a cell's side, squares told apart as places for the discs

bool is_over(const Interrupt& interrupt)
{
  return interrupt.cancelled() || interrupt.timed_out();
}

/// One of the two floods; visits cells of least `guide` first.
class Flood
{
public:
  Flood(FreeHeadings& free, const CoarseCells& cells, std::function<double(int)> guide)
    : free_(free),
      cells_(cells),
      guide_(std::move(guide)),
      reached_(cells.count(), 0)
  {}

  void begin(const Pose& pose)
  {
    const WholeTurnSet here = WholeTurnSet{1} << whole_turn_bin(pose.theta);
    reach(cells_.index(pose.x, pose.y), here | turned_by_one_bin(here));
  }

  bool exhausted() const { return queue_.empty(); }
  WholeTurnSet reached(int cell) const { return reached_[static_cast<std::size_t>(cell)]; }

  /// Continues the flood from one cell, which is returned.
  int step()
  {
    const int here = queue_.top().second;
    queue_.pop();
    const WholeTurnSet set = reached(here);
    cells_.for_neighbours(here, [&](int next, bool) { reach(next, set & from_both_sides(free_[next])); });
    return here;
  }

private:
  /// Adds headings to a cell, and those the robot can turn to from them.
  void reach(int cell, WholeTurnSet set)
  {
    WholeTurnSet& known = reached_[static_cast<std::size_t>(cell)];
    if ((set & ~known) == 0) return;
    const WholeTurnSet free = from_both_sides(free_[cell]);
    for (WholeTurnSet next = known | set; next != known; next |= turned_by_one_bin(next) & free) known = next;
    queue_.push({guide_(cell), cell});
  }

  FreeHeadings& free_;
  const CoarseCells& cells_;
  std::function<double(int)> guide_;
  std::vector<WholeTurnSet> reached_;
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue_;
};

}  // namespace

bool may_be_reachable(const SearchProblem& problem, const GoalDistance& distance, double cell_size, Proof proof)
{
  const CollisionChecker& checker = problem.checker;
  const Interrupt& interrupt = problem.interrupt;
  const CoarseCells cells(checker.map(), cell_size);
  std::optional<DiscPlaces> places;
  if (proof == Proof::sharp)
    places.emplace(checker.map(), checker.least_clearance(), cell_size / kSquaresPerCell, interrupt);
  FreeHeadings free(checker, cells, places ? &*places : nullptr);
  Flood from_start(free, cells, [&](int cell) {
    const Pose centre = cells.centre(cell);
    return distance(centre.x, centre.y);
  });
  Flood from_goal(free, cells, [&](int cell) { return fourwis::distance(cells.centre(cell), problem.start); });
  from_start.begin(problem.start);
  from_goal.begin(problem.goal);
  for (int steps = 1; !from_start.exhausted() && !from_goal.exhausted(); ++steps)
  {
    const int a = from_start.step(), b = from_goal.step();
    if (from_start.reached(a) & from_goal.reached(a)) return true;
    if (from_start.reached(b) & from_goal.reached(b)) return true;
    if (steps % kInterruptInterval == 0 && is_over(interrupt)) return true;
  }
  return is_over(interrupt);  // then the places are not complete
}

}  // namespace fourwis
