#include "closest_points.h"

#include <algorithm>
#include <cmath>

namespace fourwis
{
namespace
{

/// Shorter chords have no direction [m].
constexpr double kPoint = 1e-9;

double squared(const Point2& a, const Point2& b)
{
  const double dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

/// Separating axes: x, y and the chord's normal.
bool meet(const Chord& chord, const Box& box)
{
  if (std::max(chord.a.x, chord.b.x) < box.x_min || std::min(chord.a.x, chord.b.x) > box.x_max) return false;
  if (std::max(chord.a.y, chord.b.y) < box.y_min || std::min(chord.a.y, chord.b.y) > box.y_max) return false;
  const double nx = -chord.along.y, ny = chord.along.x, offset = nx * chord.a.x + ny * chord.a.y;
  return least_along(box, nx, ny) <= offset && -least_along(box, -nx, -ny) >= offset;
}

/// If two convex shapes do not meet, one of the nearest points is a corner of its shape.
template <typename Consider>
void each_candidate(const Chord& chord, const Box& box, Consider consider)
{
  for (const Point2& end : {chord.a, chord.b}) consider(end, nearest(box, end));
  for (double x : {box.x_min, box.x_max})
    for (double y : {box.y_min, box.y_max}) consider(chord.nearest({x, y}), Point2{x, y});
}

}  // namespace

Chord::Chord(const Point2& from, const Point2& to) : a(from), b(to), along{1.0, 0.0}, inverse_squared(0.0)
{
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length < kPoint) return;
  along = {(b.x - a.x) / length, (b.y - a.y) / length};
  inverse_squared = 1.0 / (length * length);
}

Point2 Chord::nearest(const Point2& point) const
{
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = std::clamp(((point.x - a.x) * dx + (point.y - a.y) * dy) * inverse_squared, 0.0, 1.0);
  return {a.x + t * dx, a.y + t * dy};
}

Point2 nearest(const Box& rectangle, const Point2& point)
{
  return {std::clamp(point.x, rectangle.x_min, rectangle.x_max), std::clamp(point.y, rectangle.y_min, rectangle.y_max)};
}

ClosestPoints closest_points(const Chord& chord, const Box& rectangle)
{
  if (meet(chord, rectangle)) return {chord.a, chord.a, 0.0};
  ClosestPoints best{chord.a, chord.a, INFINITY};
  each_candidate(chord, rectangle, [&](const Point2& on_chord, const Point2& on_rectangle) {
    const double distance = squared(on_chord, on_rectangle);
    if (distance < best.squared_distance) best = {on_chord, on_rectangle, distance};
  });
  return best;
}

double squared_distance(const Chord& chord, const Box& rectangle)
{
  if (meet(chord, rectangle)) return 0.0;
  double best = INFINITY;
  each_candidate(chord, rectangle, [&](const Point2& on_chord, const Point2& on_rectangle) {
    best = std::min(best, squared(on_chord, on_rectangle));
  });
  return best;
}

}  // namespace fourwis
