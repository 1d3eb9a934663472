#include "maps.h"

#include <algorithm>
#include <utility>

#include "drawing.h"

namespace fourwis::nightly
{
namespace
{

/// Metres of the default robot, and cells of 5 cm unless told otherwise.
class Scaled
{
public:
  Scaled(double length, double width, double scale, double cell = 0.05)
    : scale_(scale),
      drawing_(scale * length, scale * width, scale * cell)
  {}

  void box(double left, double bottom, double right, double top)
  {
    drawing_.box(scale_ * left, scale_ * bottom, scale_ * right, scale_ * top);
  }
  void opening(double left, double bottom, double right, double top)
  {
    drawing_.opening(scale_ * left, scale_ * bottom, scale_ * right, scale_ * top);
  }
  void rectangle(const Pose& middle, double length, double width)
  {
    drawing_.rectangle({scale_ * middle.x, scale_ * middle.y, middle.theta}, scale_ * length, scale_ * width);
  }
  void disc(double x, double y, double radius) { drawing_.disc(scale_ * x, scale_ * y, scale_ * radius); }
  void frame() { drawing_.frame(scale_ * 0.05); }
  const OccupancyGrid& grid() const { return drawing_.grid(); }

private:
  double scale_;
  Drawing drawing_;
};

/// Cells of a maze and thin walls; each cell can be reached from each, and a few walls more are open.
OccupancyGrid maze(Random& random, double scale)
{
  const int columns = random.whole(4, 5), rows = random.whole(4, 5);
  const double lane = random.between(1.05, 1.6);
  Scaled map(columns * lane, rows * lane, scale);
  for (int i = 0; i <= columns; ++i) map.box(i * lane - 0.05, 0.0, i * lane + 0.05, rows * lane);
  for (int j = 0; j <= rows; ++j) map.box(0.0, j * lane - 0.05, columns * lane, j * lane + 0.05);
  const auto open = [&](int i, int j, bool to_the_right) {
    const double x = i * lane, y = j * lane;
    if (to_the_right)
      map.opening(x + lane - 0.05, y + 0.05, x + lane + 0.05, y + lane - 0.05);
    else
      map.opening(x + 0.05, y + lane - 0.05, x + lane - 0.05, y + lane + 0.05);
  };
  // Depth first, from a stack of cells.
  std::vector<std::pair<int, int>> stack{{0, 0}};
  std::vector<bool> seen(static_cast<std::size_t>(columns * rows), false);
  seen[0] = true;
  while (!stack.empty())
  {
    const auto [i, j] = stack.back();
    std::vector<std::pair<int, int>> next;
    for (const auto& [di, dj] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}})
      if (i + di >= 0 && i + di < columns && j + dj >= 0 && j + dj < rows &&
          !seen[static_cast<std::size_t>((j + dj) * columns + i + di)])
        next.emplace_back(i + di, j + dj);
    if (next.empty())
    {
      stack.pop_back();
      continue;
    }
    const auto [to_i, to_j] = next[static_cast<std::size_t>(random.whole(0, static_cast<int>(next.size()) - 1))];
    open(std::min(i, to_i), std::min(j, to_j), to_j == j);
    seen[static_cast<std::size_t>(to_j * columns + to_i)] = true;
    stack.emplace_back(to_i, to_j);
  }
  for (int k = 0; k < 3; ++k) open(random.whole(0, columns - 2), random.whole(0, rows - 2), random.chance(0.5));
  return map.grid();
}

/// Rooms with doors of 0.65 to 1.1 m, and furniture.
OccupancyGrid rooms(Random& random, double scale)
{
  const double size = 7.5;
  Scaled map(size, size, scale);
  map.frame();
  const double x = random.between(3.0, 4.5), y = random.between(3.0, 4.5);
  map.box(x, 0.0, x + 0.1, size);
  map.box(0.0, y, size, y + 0.1);
  for (const auto& [low, high] : {std::pair(0.2, x - 1.2), {x + 0.2, size - 1.3}})
  {
    const double door = random.between(low, high);
    map.opening(door, y, door + random.between(0.65, 1.1), y + 0.1);
  }
  for (const auto& [low, high] : {std::pair(0.2, y - 1.2), {y + 0.2, size - 1.3}})
  {
    const double door = random.between(low, high);
    map.opening(x, door, x + 0.1, door + random.between(0.65, 1.1));
  }
  for (int k = 0; k < 8; ++k)
  {
    const double left = random.between(0.0, size), bottom = random.between(0.0, size);
    map.box(left, bottom, left + random.between(0.1, 0.5), bottom + random.between(0.1, 0.5));
  }
  return map.grid();
}

/// Rows of bays as big as the robot and a little more, some of them taken.
OccupancyGrid car_park(Random& random, double scale)
{
  const double bay = random.between(0.8, 1.0), lane = random.between(1.1, 1.8), depth = 1.2;
  Scaled map(8.0, 2.0 * depth + lane + 0.4, scale);
  map.frame();
  for (int k = 0; k * bay + 1.0 < 7.5; ++k)
    for (bool above : {false, true})
    {
      const double x = 0.6 + k * bay, y = above ? depth + lane + 0.2 : 0.2;
      map.box(x - 0.05, y, x, y + depth);
      if (random.chance(0.5)) map.box(x + 0.1, y + 0.1, x + bay - 0.15, y + depth - 0.1);
    }
  return map.grid();
}

/// Boxes of any heading.
OccupancyGrid scattered_boxes(Random& random, double scale, int least, int most)
{
  const double size = 7.0;
  Scaled map(size, size, scale);
  for (int k = random.whole(least, most); k > 0; --k)
    map.rectangle({random.between(0.0, size), random.between(0.0, size), random.chance(0.5) ? 0.0 : random.angle()},
                  random.between(0.1, 0.9), random.between(0.1, 0.6));
  return map.grid();
}
OccupancyGrid light_clutter(Random& random, double scale)
{
  return scattered_boxes(random, scale, 8, 14);
}
OccupancyGrid clutter_boxes(Random& random, double scale)
{
  return scattered_boxes(random, scale, 18, 28);
}
OccupancyGrid dense_clutter(Random& random, double scale)
{
  return scattered_boxes(random, scale, 32, 45);
}

/// A block with corridors cut into it, 0.7 to 1.2 m wide, that meet at right angles.
OccupancyGrid corridors(Random& random, double scale)
{
  const double size = 7.0;
  Scaled map(size, size, scale);
  map.box(0.0, 0.0, size, size);
  for (int k = 0; k < 3; ++k)
  {
    const double wide = random.between(0.7, 1.2), x = 0.2 + k * 2.3 + random.between(0.0, 0.8);
    map.opening(x, 0.1, x + wide, size - 0.1);
    const double high = random.between(0.7, 1.2), y = 0.2 + k * 2.3 + random.between(0.0, 0.8);
    map.opening(0.1, y, size - 0.1, y + high);
  }
  for (int k = 0; k < 3; ++k)
  {
    const double x = random.between(0.5, 6.0), y = random.between(0.5, 6.0);
    map.box(x, y, x + 0.2, y + 0.2);
  }
  return map.grid();
}

/// Shelves with aisles between them, and pallets in the way.
OccupancyGrid warehouse(Random& random, double scale)
{
  Scaled map(9.0, 6.5, scale);
  map.frame();
  const double aisle = random.between(0.8, 1.3);
  for (double y = 1.2; y + 0.5 < 6.0; y += 0.5 + aisle)
    for (double x : {1.0, 4.9}) map.box(x, y, x + random.between(2.6, 3.2), y + 0.5);
  for (int k = 0; k < 6; ++k)
  {
    const double x = random.between(0.0, 8.6), y = random.between(0.0, 6.1);
    map.box(x, y, x + 0.3, y + 0.3);
  }
  return map.grid();
}

/// Posts in rows that are not quite rows.
OccupancyGrid posts(Random& random, double scale)
{
  Scaled map(7.0, 7.0, scale);
  const double apart = random.between(1.0, 1.35);
  for (double x = 0.6; x < 7.0; x += apart)
    for (double y = 0.6; y < 7.0; y += apart)
      map.disc(x + random.between(-0.15, 0.15), y + random.between(-0.15, 0.15), random.between(0.05, 0.12));
  return map.grid();
}

/// Walls across, each with a gap of 0.60 to 0.90 m, in cells of 1 to 5 cm.
OccupancyGrid gaps(Random& random, double scale)
{
  const double cells[] = {0.01, 0.02, 0.025, 0.05};
  Scaled map(6.4, 4.0, scale, cells[random.whole(0, 3)]);
  for (double x : {1.6, 3.2, 4.8})
  {
    const double gap = random.chance(0.5) ? random.between(0.62, 0.72) : random.between(0.66, 0.90);
    const double y = random.between(0.1, 3.9 - gap);
    map.box(x - 0.1, 0.0, x + 0.1, 4.0);
    map.opening(x - 0.1, y, x + 0.1, y + gap);
  }
  return map.grid();
}

/// A corridor that winds into the middle.
OccupancyGrid spiral(Random& random, double scale)
{
  const double lane = random.between(0.9, 1.15), wall = 0.1, step = lane + wall, size = 6.0 * step + wall;
  Scaled map(size, size, scale);
  map.frame();
  double low = 0.0, high = size;
  for (int turn = 0; turn < 3 && high - low > 2.0 * step; ++turn)
  {
    // Each wall ends a lane before the one that comes next.
    map.box(low, low + step, high - step, low + step + wall);
    map.box(high - step - wall, low + step, high - step, high - step);
    map.box(low + step, high - step - wall, high - step, high - step);
    map.box(low + step, low + 2.0 * step, low + step + wall, high - step);
    low += step;
    high -= step;
  }
  return map.grid();
}

/// Walls of any heading, with gaps.
OccupancyGrid slanted_walls(Random& random, double scale)
{
  const double size = 7.0;
  Scaled map(size, size, scale);
  const double heading = random.angle();
  for (double beside : {-1.6, 0.0, 1.6})
  {
    const Pose middle = compose({size / 2.0, size / 2.0, heading}, {random.between(-1.5, 1.5), beside, 0.0});
    const double gap = random.between(0.66, 1.1);
    for (int side : {-1, 1})
      map.rectangle(compose(middle, {side * (gap / 2.0 + 5.0), 0.0, random.between(-0.05, 0.05)}), 10.0, 0.15);
  }
  return map.grid();
}

/// Pockets as big as the robot in thick walls, entered forward or sideways.
OccupancyGrid pockets(Random& random, double scale)
{
  Scaled map(7.0, 5.0, scale);
  const double bottom = 1.4, top = bottom + random.between(1.1, 1.6);
  map.box(0.0, 0.0, 7.0, bottom);
  map.box(0.0, top, 7.0, 5.0);
  for (bool above : {false, true})
    for (double x = 0.3; x < 5.6;)
    {
      const bool sideways = random.chance(0.5);
      const double wide = (sideways ? 1.04 : 0.66) + random.between(0.0, 0.25), deep = sideways ? 0.75 : 1.15;
      if (above)
        map.opening(x, top, x + wide, top + deep);
      else
        map.opening(x, bottom - deep, x + wide, bottom);
      x += wide + random.between(0.2, 0.6);
    }
  return map.grid();
}

}  // namespace

const std::vector<MapKind>& map_kinds()
{
  static const std::vector<MapKind> kinds = {
      {"maze", maze},
      {"rooms", rooms},
      {"car_park", car_park},
      {"light_clutter", light_clutter},
      {"clutter", clutter_boxes},
      {"dense_clutter", dense_clutter},
      {"corridors", corridors},
      {"warehouse", warehouse},
      {"posts", posts},
      {"gaps", gaps},
      {"spiral", spiral},
      {"slanted_walls", slanted_walls},
      {"pockets", pockets},
  };
  return kinds;
}

}  // namespace fourwis::nightly
