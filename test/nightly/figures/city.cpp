#include "city.h"

#include <array>
#include <cmath>
#include <queue>

#include "drawing.h"

namespace fourwis::nightly
{
namespace
{

constexpr double kClear = 0.6;       ///< around start, goal and the way between them [m]
constexpr double kFar = 1e9;         ///< where no way leads
constexpr double kTolerance = 0.15;  ///< of the way's length, as a share

OccupancyGrid streets(Random& random, double side, double resolution)
{
  Drawing drawing(side, side, resolution);
  std::vector<double> edges[2];  // left and right of each block, bottom and top
  for (std::vector<double>& edge : edges)
    for (double at = random.between(0.0, 6.0); at < side;)
    {
      const double end = at + random.between(12.0, 35.0);
      edge.insert(edge.end(), {at, end});
      at = end + random.between(2.5, 8.0);
    }
  const auto &xs = edges[0], &ys = edges[1];
  for (std::size_t i = 0; i + 1 < xs.size(); i += 2)
    for (std::size_t j = 0; j + 1 < ys.size(); j += 2)
    {
      // Houses with yards, or an open place.
      if (random.chance(0.06)) continue;
      drawing.box(xs[i], ys[j], xs[i + 1], ys[j + 1]);
      if (random.chance(0.4))
      {
        const double x = random.between(xs[i] + 2.0, xs[i + 1] - 6.0), y = ys[j];
        drawing.opening(x, y, x + random.between(2.0, 5.0), y + random.between(3.0, 8.0));
      }
      // A street that is closed: to the right of the block, or above it.
      if (random.chance(0.12) && i + 2 < xs.size()) drawing.box(xs[i + 1], ys[j] + 4.0, xs[i + 2], ys[j] + 5.0);
      if (random.chance(0.12) && j + 2 < ys.size()) drawing.box(xs[i] + 4.0, ys[j + 1], xs[i] + 5.0, ys[j + 2]);
    }
  // What stands about.
  for (int k = static_cast<int>(side * side / 150.0); k > 0; --k)
    drawing.rectangle({random.between(0.0, side), random.between(0.0, side), random.angle()}, random.between(0.3, 1.8),
                      random.between(0.3, 1.0));
  return drawing.grid();
}

/// Cells whose middle keeps a distance from all obstacles and from the border.
std::vector<bool> clear_cells(const OccupancyGrid& grid)
{
  std::vector<bool> clear(grid.data.size(), true);
  const ObstacleRule rule;
  const int reach = static_cast<int>(std::ceil(kClear / grid.resolution + 0.5));
  for (int row = -1; row <= grid.height; ++row)
    for (int column = -1; column <= grid.width; ++column)
    {
      const bool inside = row >= 0 && column >= 0 && row < grid.height && column < grid.width;
      if (inside && !rule.is_obstacle(grid.at(column, row))) continue;
      for (int j = std::max(0, row - reach); j <= std::min(grid.height - 1, row + reach); ++j)
        for (int i = std::max(0, column - reach); i <= std::min(grid.width - 1, column + reach); ++i)
          if (std::hypot(std::max(0.0, std::abs(i - column) - 0.5), std::max(0.0, std::abs(j - row) - 0.5)) *
                  grid.resolution <
              kClear)
            clear[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(i)] =
                false;
    }
  return clear;
}

/// Length of the shortest way over clear cells and their eight neighbours, from one cell to each [m].
std::vector<double> ways_from(const OccupancyGrid& grid, const std::vector<bool>& clear, std::size_t from)
{
  std::vector<double> way(clear.size(), kFar);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  way[from] = 0.0;
  queue.push({0.0, from});
  while (!queue.empty())
  {
    const auto [length, cell] = queue.top();
    queue.pop();
    if (length > way[cell]) continue;
    const int column = static_cast<int>(cell % static_cast<std::size_t>(grid.width));
    const int row = static_cast<int>(cell / static_cast<std::size_t>(grid.width));
    for (int j = std::max(0, row - 1); j <= std::min(grid.height - 1, row + 1); ++j)
      for (int i = std::max(0, column - 1); i <= std::min(grid.width - 1, column + 1); ++i)
      {
        const std::size_t next =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(i);
        const double to = length + grid.resolution * std::hypot(i - column, j - row);
        if (!clear[next] || to >= way[next]) continue;
        way[next] = to;
        queue.push({to, next});
      }
  }
  return way;
}

}  // namespace

CityDrive city_drive(int number, double way, double resolution)
{
  Random random(static_cast<unsigned>(number));
  const double side = std::max(40.0, 0.75 * way);
  for (;;)
  {
    const OccupancyGrid grid = streets(random, side, resolution);
    const std::vector<bool> clear = clear_cells(grid);
    std::vector<std::size_t> free;
    for (std::size_t k = 0; k < clear.size(); ++k)
      if (clear[k]) free.push_back(k);
    const auto any = [&] { return free[static_cast<std::size_t>(random.whole(0, static_cast<int>(free.size()) - 1))]; };
    for (int trial = 0; trial < 10 && !free.empty(); ++trial)
    {
      const std::size_t from = any();
      const std::vector<double> ways = ways_from(grid, clear, from);
      for (int other = 0; other < 200; ++other)
      {
        const std::size_t to = any();
        if (std::abs(ways[to] - way) > kTolerance * way) continue;
        const auto pose_at = [&](std::size_t cell) {
          const std::size_t width = static_cast<std::size_t>(grid.width);
          return Pose{(static_cast<double>(cell % width) + 0.5) * resolution,
                      (static_cast<double>(cell / width) + 0.5) * resolution, random.angle()};
        };
        const Pose start = pose_at(from), goal = pose_at(to);
        return {"city_" + std::to_string(number), grid, start, goal, ways[to]};
      }
    }
  }
}

}  // namespace fourwis::nightly
