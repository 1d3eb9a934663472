#include "goal_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fourwis
{
namespace
{

constexpr double kCellSize = 0.1;            ///< side of a cell [m]
constexpr int kStraight = 5, kDiagonal = 7;  ///< integer lengths of steps; 7/5 < sqrt(2)
constexpr double kOctileExcess = 1.0824;     ///< longest 8-connected path over the straight line
constexpr float kUnseen = std::numeric_limits<float>::infinity();
constexpr int kInterruptInterval = 4096;  ///< cells settled between two looks at the interrupt

/// A priority queue for steps of small integer lengths: a ring of buckets.
class BucketQueue
{
public:
  void push(int distance, int cell)
  {
    bucket(distance).push_back(cell);
    ++size_;
  }
  bool empty() const { return size_ == 0; }

  /// Hands out every cell pushed for `distance`, also those that are pushed meanwhile.
  template <typename Visit>
  void drain(int distance, Visit visit)
  {
    std::vector<int>& cells = bucket(distance);
    for (std::size_t k = 0; k < cells.size(); ++k, --size_) visit(cells[k]);
    cells.clear();
  }

private:
  std::vector<int>& bucket(int distance) { return buckets_[static_cast<std::size_t>(distance) % buckets_.size()]; }

  std::array<std::vector<int>, kDiagonal + 1> buckets_;
  std::size_t size_ = 0;
};

/// Least clearance that C, the centre of the wheels, can have where the robot fits at some heading. In the middle between the
/// discs it is least where both centres are as close to one point as they can be; C has less by its distance from there.
double least_clearance(const CollisionChecker& checker)
{
  const TwoDiscs& discs = checker.discs();
  const double radius = checker.least_clearance(), offset = discs.offset;
  return std::sqrt(std::max(0.0, radius * radius - offset * offset)) - std::hypot(discs.middle.x, discs.middle.y);
}

}  // namespace

CoarseCells::CoarseCells(const ObstacleMap& map, double size)
  : map_(map),
    size_(size),
    per_map_cell_(map.resolution() / size),
    width_(std::max(1, static_cast<int>(std::ceil(map.width() * per_map_cell_ - 1e-9)))),
    height_(std::max(1, static_cast<int>(std::ceil(map.height() * per_map_cell_ - 1e-9))))
{}

int CoarseCells::index(double x, double y) const
{
  double u, v;
  map_.to_cells(x, y, u, v);
  const int column = std::clamp(static_cast<int>(u * per_map_cell_), 0, width_ - 1);
  const int row = std::clamp(static_cast<int>(v * per_map_cell_), 0, height_ - 1);
  return row * width_ + column;
}

Pose CoarseCells::centre(int index) const
{
  const int column = index % width_, row = index / width_;
  return compose(map_.origin(), {(column + 0.5) * size_, (row + 0.5) * size_, 0.0});
}

bool GoalDistance::is_passable(const CollisionChecker& checker, int cell) const
{
  // No point of the cell is further from the obstacles than its centre by more than half its diagonal.
  const Pose centre = cells_.centre(cell);
  return checker.map().is_clear(centre.x, centre.y, least_clearance(checker) - M_SQRT1_2 * cells_.size());
}

GoalDistance::GoalDistance(const SearchProblem& problem, double slack)
  : cells_(problem.checker.map(), kCellSize),
    field_(cells_.count(), kUnseen)
{
  const Interrupt& interrupt = problem.interrupt;
  const int start_cell = cells_.index(problem.start.x, problem.start.y);
  const int goal_cell = cells_.index(problem.goal.x, problem.goal.y);
  const double unit = cells_.size() / kStraight;
  std::vector<std::int8_t> passable(cells_.count(), -1);  // -1 not asked yet
  passable[static_cast<std::size_t>(start_cell)] = 1;
  BucketQueue queue;
  field_[static_cast<std::size_t>(goal_cell)] = 0.0f;
  queue.push(0, goal_cell);
  int distance = 0, last_distance = std::numeric_limits<int>::max() - 1, settled = 0;
  for (; !queue.empty() && distance <= last_distance; ++distance)
    queue.drain(distance, [&](int here) {
      if (field_[static_cast<std::size_t>(here)] != static_cast<float>(distance)) return;
      if (++settled % kInterruptInterval == 0 && (interrupt.cancelled() || interrupt.timed_out())) last_distance = -1;
      if (here == start_cell)
      {
        reaches_start_ = true;
        last_distance = std::min(last_distance, distance + static_cast<int>(slack / unit));
      }
      cells_.for_neighbours(here, [&](int next_cell, bool diagonal) {
        const std::size_t next = static_cast<std::size_t>(next_cell);
        const int reach = distance + (diagonal ? kDiagonal : kStraight);
        if (field_[next] <= static_cast<float>(reach)) return;
        if (passable[next] < 0) passable[next] = is_passable(problem.checker, next_cell);
        if (!passable[next]) return;
        field_[next] = static_cast<float>(reach);
        queue.push(reach, next_cell);
      });
    });

  const float edge = queue.empty() ? kUnseen : static_cast<float>(distance);
  const float metres = static_cast<float>(unit / kOctileExcess), rounding = static_cast<float>(M_SQRT2 * cells_.size());
  for (float& value : field_) value = std::max(0.0f, std::min(value, edge) * metres - rounding);
}

}  // namespace fourwis
