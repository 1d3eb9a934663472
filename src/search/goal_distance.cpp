#include "fourwis_navigation/search/goal_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fourwis
{
namespace
{

constexpr double kCell = 0.1;               ///< wanted side of a cell [m]
constexpr int kStraight = 5, kDiagonal = 7;  ///< integer lengths of steps; 7/5 < sqrt(2)
constexpr float kUnseen = std::numeric_limits<float>::infinity();
constexpr double kOctileExcess = 1.0824;    ///< longest 8-connected path over the straight line

/// Least clearance C can have where the robot fits at some heading: both discs of radius r_c touch one point.
double least_clearance(const TwoDiscs& discs)
{
  return std::sqrt(std::max(0.0, discs.radius * discs.radius - discs.offset * discs.offset));
}

}  // namespace

GoalDistance::GoalDistance(const CollisionChecker& checker, const Pose& start, const Pose& goal, double slack)
  : map_(checker.map()), factor_(std::max(1, static_cast<int>(std::lround(kCell / map_.resolution()))))
{
  width_ = (map_.width() + factor_ - 1) / factor_;
  height_ = (map_.height() + factor_ - 1) / factor_;
  cell_size_ = factor_ * map_.resolution();
  field_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), kUnseen);

  // A cell is passed through if any point in it may be far enough from all obstacles.
  const double needed = least_clearance(checker.discs()) - M_SQRT2 * map_.resolution();
  const auto passable = [&](int column, int row) {
    for (int j = row * factor_; j < std::min(map_.height(), (row + 1) * factor_); ++j)
      for (int i = column * factor_; i < std::min(map_.width(), (column + 1) * factor_); ++i)
        if (map_.cell_distance(i, j) >= needed) return true;
    return false;
  };

  // Steps are small integers, so a ring of buckets is a priority queue.
  std::array<std::vector<int>, kDiagonal + 1> buckets;
  const std::size_t start_cell = cell(start.x, start.y), goal_cell = cell(goal.x, goal.y);
  field_[goal_cell] = 0.0f;
  buckets[0].push_back(static_cast<int>(goal_cell));
  int pending = 1, distance = 0, stop_at = std::numeric_limits<int>::max();
  const double unit = cell_size_ / kStraight;
  std::vector<std::int8_t> known(field_.size(), -1);
  for (; pending > 0 && distance <= stop_at; ++distance)
  {
    std::vector<int>& bucket = buckets[static_cast<std::size_t>(distance) % buckets.size()];
    for (std::size_t k = 0; k < bucket.size(); ++k)
    {
      const int here = bucket[k];
      --pending;
      if (field_[static_cast<std::size_t>(here)] != static_cast<float>(distance)) continue;
      if (static_cast<std::size_t>(here) == start_cell && !reaches_start_)
      {
        reaches_start_ = true;
        stop_at = distance + static_cast<int>(slack / unit);
      }
      const int column = here % width_, row = here / width_;
      for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di)
        {
          const int i = column + di, j = row + dj;
          if (i < 0 || j < 0 || i >= width_ || j >= height_) continue;
          const std::size_t next = static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i);
          const int reach = distance + (di != 0 && dj != 0 ? kDiagonal : kStraight);
          if (field_[next] <= static_cast<float>(reach)) continue;
          if (known[next] < 0) known[next] = passable(i, j);
          if (!known[next]) continue;
          field_[next] = static_cast<float>(reach);
          buckets[static_cast<std::size_t>(reach) % buckets.size()].push_back(static_cast<int>(next));
          ++pending;
        }
    }
    bucket.clear();
  }

  beyond_ = pending > 0 ? static_cast<float>(distance) : kUnseen;
  const float metres = static_cast<float>(unit / kOctileExcess), rounding = static_cast<float>(M_SQRT2 * cell_size_);
  const auto shorten = [&](float value) { return std::max(0.0f, std::min(value, beyond_) * metres - rounding); };
  for (float& value : field_) value = shorten(value);
}

std::size_t GoalDistance::cell(double x, double y) const
{
  double u, v;
  map_.to_cells(x, y, u, v);
  const int column = std::clamp(static_cast<int>(u) / factor_, 0, width_ - 1);
  const int row = std::clamp(static_cast<int>(v) / factor_, 0, height_ - 1);
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
}

double GoalDistance::operator()(double x, double y) const
{
  return field_[cell(x, y)];
}

}  // namespace fourwis
