#include "box_growth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "placed_box.h"

namespace fourwis
{
namespace
{

/// Sums of steps may pass d_max by this much [m].
constexpr double kRounding = 1e-9;

/// A side of a box.
struct Side
{
  double Box::*bound;
  double Box::*opposite;
  double outward;  ///< sign of the direction in which it grows
};

constexpr Side kRight{&Box::x_max, &Box::x_min, 1.0}, kLeft{&Box::x_min, &Box::x_max, -1.0};
constexpr Side kUp{&Box::y_max, &Box::y_min, 1.0}, kDown{&Box::y_min, &Box::y_max, -1.0};

/// DirSorted, paper Algorithm 2.
std::array<Side, 4> expansion_order(const Point2& motion)
{
  const bool right = motion.x >= 0.0, up = motion.y >= 0.0;
  const Side along_x = right ? kRight : kLeft, against_x = right ? kLeft : kRight;
  const Side along_y = up ? kUp : kDown, against_y = up ? kDown : kUp;
  if (std::abs(motion.x) >= std::abs(motion.y)) return {along_x, along_y, against_x, against_y};
  return {along_y, along_x, against_y, against_x};
}

/// What a step of a side adds to a box.
Box strip_beyond(const Box& box, const Side& side, double step)
{
  Box strip = box;
  strip.*side.opposite = box.*side.bound;
  strip.*side.bound += side.outward * step;
  return strip;
}

/// How far a side has grown.
struct Progress
{
  Side side;
  double total = 0.0;  ///< [m]
  bool is_fine = false;
  bool is_blocked = false;
};

}  // namespace

Box grow_box(const ObstacleRectangles& obstacles, const Pose& waypoint, const Point2& motion, double radius,
             const BoxOptions& options)
{
  Box box{waypoint.x, waypoint.y, waypoint.x, waypoint.y};
  std::array<Progress, 4> sides;
  const std::array<Side, 4> order = expansion_order(motion);
  for (std::size_t q = 0; q < order.size(); ++q) sides[q].side = order[q];
  while (std::any_of(sides.begin(), sides.end(), [](const Progress& p) { return !p.is_blocked; }))
    for (Progress& p : sides)
    {
      if (p.is_blocked) continue;
      const double step = p.is_fine ? options.fine_step : options.coarse_step;
      const Box strip = strip_beyond(box, p.side, step);
      // The box without the strip is known to be free.
      if (p.total + step <= options.max_expansion + kRounding && PlacedBox(obstacles, strip).is_clear(radius))
      {
        box.*p.side.bound = strip.*p.side.bound;
        p.total += step;
      }
      else
      {
        p.is_blocked = p.is_fine;
        p.is_fine = true;
      }
    }
  return box;
}

}  // namespace fourwis
