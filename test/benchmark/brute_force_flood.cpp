#include "brute_force_flood.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fourwis::benchmark
{
namespace
{

constexpr double kStep = 0.025;  ///< between neighbours of the lattice [m]
constexpr int kHeadings = 60;    ///< headings of the lattice over half a turn: both discs are alike
constexpr double kTurn = M_PI / kHeadings;

struct LatticePose
{
  int x, y, heading;
};

/// Poses start + (i, j) kStep, k kTurn that lie in the grid, numbered.
class Lattice
{
public:
  Lattice(const OccupancyGrid& grid, const Pose& start)
    : start_(start),
      left_(static_cast<int>(start.x / kStep)),
      below_(static_cast<int>(start.y / kStep)),
      width_(left_ + 1 + static_cast<int>((grid.width * grid.resolution - start.x) / kStep)),
      height_(below_ + 1 + static_cast<int>((grid.height * grid.resolution - start.y) / kStep))
  {}

  std::size_t size() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * kHeadings; }
  bool contains(const LatticePose& p) const { return p.x >= 0 && p.x < width_ && p.y >= 0 && p.y < height_; }
  std::size_t index(const LatticePose& p) const
  {
    return (static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(p.x)) *
               kHeadings +
           static_cast<std::size_t>(p.heading);
  }
  Pose pose(const LatticePose& p) const
  {
    return {start_.x + (p.x - left_) * kStep, start_.y + (p.y - below_) * kStep, start_.theta + p.heading * kTurn};
  }
  LatticePose nearest(const Pose& pose) const
  {
    const int turns = static_cast<int>(std::lround((pose.theta - start_.theta) / kTurn));
    return {left_ + static_cast<int>(std::lround((pose.x - start_.x) / kStep)),
            below_ + static_cast<int>(std::lround((pose.y - start_.y) / kStep)),
            (turns % kHeadings + kHeadings) % kHeadings};
  }

private:
  Pose start_;
  int left_, below_;  ///< steps from the lattice's corner to the start
  int width_, height_;
};

}  // namespace

BruteForceFlood::BruteForceFlood(const OccupancyGrid& grid, const ObstacleRule& rule, const Robot& robot)
  : grid_(grid),
    rule_(rule),
    offset_(robot.length / 4.0),
    radius_(std::hypot(robot.length / 4.0, robot.width / 2.0) + robot.safety_margin)
{
  if (grid.origin.x != 0.0 || grid.origin.y != 0.0 || grid.origin.theta != 0.0)
    throw std::logic_error("the flood expects the grid at the origin");
}

bool BruteForceFlood::is_free(double x, double y) const
{
  const double cell = grid_.resolution, width = grid_.width * cell, height = grid_.height * cell;
  if (x < radius_ || y < radius_ || x > width - radius_ || y > height - radius_) return false;
  const int right = std::min(grid_.width - 1, static_cast<int>((x + radius_) / cell));
  const int top = std::min(grid_.height - 1, static_cast<int>((y + radius_) / cell));
  for (int row = static_cast<int>((y - radius_) / cell); row <= top; ++row)
    for (int column = static_cast<int>((x - radius_) / cell); column <= right; ++column)
    {
      if (!rule_.is_obstacle(grid_.at(column, row))) continue;
      const double dx = x - std::clamp(x, column * cell, (column + 1) * cell);
      const double dy = y - std::clamp(y, row * cell, (row + 1) * cell);
      if (std::hypot(dx, dy) < radius_) return false;
    }
  return true;
}

bool BruteForceFlood::is_free(const Pose& pose) const
{
  const double dx = offset_ * std::cos(pose.theta), dy = offset_ * std::sin(pose.theta);
  return is_free(pose.x + dx, pose.y + dy) && is_free(pose.x - dx, pose.y - dy);
}

bool BruteForceFlood::joins(const Pose& start, const Pose& goal) const
{
  const Lattice lattice(grid_, start);
  const std::size_t end = lattice.index(lattice.nearest(goal));
  std::vector<bool> seen(lattice.size(), false);
  std::vector<LatticePose> stack{lattice.nearest(start)};
  seen[lattice.index(stack.back())] = true;
  while (!stack.empty())
  {
    const LatticePose p = stack.back();
    stack.pop_back();
    if (lattice.index(p) == end) return true;
    const int left = (p.heading + 1) % kHeadings, right = (p.heading + kHeadings - 1) % kHeadings;
    for (const LatticePose& next : {LatticePose{p.x + 1, p.y, p.heading}, LatticePose{p.x - 1, p.y, p.heading},
                                    LatticePose{p.x, p.y + 1, p.heading}, LatticePose{p.x, p.y - 1, p.heading},
                                    LatticePose{p.x, p.y, left}, LatticePose{p.x, p.y, right}})
    {
      if (!lattice.contains(next) || seen[lattice.index(next)]) continue;
      seen[lattice.index(next)] = true;
      if (is_free(lattice.pose(next))) stack.push_back(next);
    }
  }
  return false;
}

}  // namespace fourwis::benchmark
