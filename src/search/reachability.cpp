#include "fourwis_navigation/search/reachability.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

namespace fourwis
{
namespace
{

/// Headings modulo pi in one word, one bit each: the two-disc model looks the same from behind.
constexpr int kHeadings = 32;
using HeadingSet = std::uint32_t;
constexpr HeadingSet kAllHeadings = ~HeadingSet{0};
constexpr double kBin = M_PI / kHeadings;   ///< [rad]
constexpr int kInterruptInterval = 1024;    ///< cells flooded between two looks at the interrupt

HeadingSet turned_by_one_bin(HeadingSet set)
{
  return set << 1 | set >> (kHeadings - 1) | set >> 1 | set << (kHeadings - 1);
}

/// Which headings may be free in each cell; computed when first asked for.
class FreeHeadings
{
public:
  FreeHeadings(const CollisionChecker& checker, const CoarseCells& cells)
    : checker_(checker), cells_(cells), known_(cells.count(), 0), free_(cells.count(), 0)
  {
    const TwoDiscs& discs = checker.discs();
    // A pose of the cell differs from the one at its centre by half a diagonal and half a bin at most.
    radius_ = discs.radius - M_SQRT1_2 * cells.size() - discs.offset * kBin / 2.0;
    for (std::size_t k = 0; k < ring_.size(); ++k)
    {
      const double angle = (static_cast<double>(k) + 0.5) * kBin;
      ring_[k] = {discs.offset * std::cos(angle), discs.offset * std::sin(angle), 0.0};
    }
  }

  HeadingSet operator[](int cell)
  {
    const std::size_t c = static_cast<std::size_t>(cell);
    if (!known_[c])
    {
      free_[c] = compute(cells_.centre(cell));
      known_[c] = 1;
    }
    return free_[c];
  }

private:
  HeadingSet compute(const Pose& centre) const
  {
    const ObstacleMap& map = checker_.map();
    if (map.is_clear(centre.x, centre.y, radius_ + checker_.discs().offset)) return kAllHeadings;
    HeadingSet free = 0;
    for (std::size_t k = 0; k < kHeadings; ++k)
      if (map.is_clear(centre.x + ring_[k].x, centre.y + ring_[k].y, radius_) &&
          map.is_clear(centre.x - ring_[k].x, centre.y - ring_[k].y, radius_))
        free |= HeadingSet{1} << k;
    return free;
  }

  const CollisionChecker& checker_;
  const CoarseCells& cells_;
  double radius_;
  std::array<Pose, kHeadings> ring_;  ///< front disc centres at each heading, relative to C
  std::vector<std::uint8_t> known_;
  std::vector<HeadingSet> free_;
};

/// One of the two floods; visits cells of least `guide` first.
class Flood
{
public:
  Flood(FreeHeadings& free, const CoarseCells& cells, std::function<double(int)> guide)
    : free_(free), cells_(cells), guide_(std::move(guide)), reached_(cells.count(), 0)
  {
  }

  void begin(const Pose& pose)
  {
    const double half_turns = pose.theta / M_PI;
    const int bin = static_cast<int>((half_turns - std::floor(half_turns)) * kHeadings) % kHeadings;
    const HeadingSet here = HeadingSet{1} << bin;
    reach(cells_.index(pose.x, pose.y), here | turned_by_one_bin(here));
  }

  bool exhausted() const { return queue_.empty(); }
  HeadingSet reached(int cell) const { return reached_[static_cast<std::size_t>(cell)]; }

  /// Floods on from one cell; returns it.
  int step()
  {
    const int here = queue_.top().second;
    queue_.pop();
    const HeadingSet set = reached(here);
    cells_.for_neighbours(here, [&](int next, bool) { reach(next, set & free_[next]); });
    return here;
  }

private:
  /// Adds headings to a cell, and those the robot can turn to from them.
  void reach(int cell, HeadingSet set)
  {
    HeadingSet& known = reached_[static_cast<std::size_t>(cell)];
    if ((set & ~known) == 0) return;
    const HeadingSet free = free_[cell];
    for (HeadingSet next = known | set; next != known; next |= turned_by_one_bin(next) & free) known = next;
    queue_.push({guide_(cell), cell});
  }

  FreeHeadings& free_;
  const CoarseCells& cells_;
  std::function<double(int)> guide_;
  std::vector<HeadingSet> reached_;
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue_;
};

}  // namespace

bool may_be_reachable(const CollisionChecker& checker, const GoalDistance& distance, const Pose& start,
                      const Pose& goal, double cell_size, const Interrupt& interrupt)
{
  const CoarseCells cells(checker.map(), cell_size);
  FreeHeadings free(checker, cells);
  Flood from_start(free, cells, [&](int cell) {
    const Pose centre = cells.centre(cell);
    return distance(centre.x, centre.y);
  });
  Flood from_goal(free, cells, [&](int cell) { return fourwis::distance(cells.centre(cell), start); });
  from_start.begin(start);
  from_goal.begin(goal);
  for (int steps = 1; !from_start.exhausted() && !from_goal.exhausted(); ++steps)
  {
    const int a = from_start.step(), b = from_goal.step();
    if (from_start.reached(a) & from_goal.reached(a)) return true;
    if (from_start.reached(b) & from_goal.reached(b)) return true;
    if (steps % kInterruptInterval == 0 && (interrupt.cancelled() || interrupt.timed_out())) return true;
  }
  return false;
}

}  // namespace fourwis
