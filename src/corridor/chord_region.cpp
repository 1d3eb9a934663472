#include "chord_region.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "polygon.h"

namespace fourwis
{
namespace
{

/// If an obstacle is this near to the chord, there is no direction for its half-plane [m].
constexpr double kTouches = 1e-6;
/// Distances are kept with this tolerance [m].
constexpr double kRounding = 1e-10;
constexpr std::size_t kRangePlanes = 4;

/// An obstacle for which there is no half-plane yet.
struct Candidate
{
  Box rectangle;
  double squared_distance;  ///< to the chord [m^2]
};

using Candidates = std::vector<Candidate>;

/// The sides of a rectangle around the chord, `extent` away from it: ahead, behind, left and right.
std::array<HalfPlane, kRangePlanes> range_planes(const Chord& chord, double extent)
{
  const Point2& u = chord.along;
  const double ahead = u.x * chord.b.x + u.y * chord.b.y, behind = u.x * chord.a.x + u.y * chord.a.y;
  const double across = std::max(-u.y * chord.a.x + u.x * chord.a.y, -u.y * chord.b.x + u.x * chord.b.y);
  return {{{u.x, u.y, ahead + extent},
           {-u.x, -u.y, extent - behind},
           {-u.y, u.x, across + extent},
           {u.y, -u.x, extent - across}}};
}

/// Whether a rectangle lies `distance` or more beyond a half-plane.
bool keeps_away(const HalfPlane& plane, const Box& rectangle, double distance)
{
  return least_along(rectangle, plane.a, plane.b) >= plane.c + distance - kRounding;
}

/// Obstacles nearer than `keep` to the rectangle of the range.
Candidates near(const ObstacleRectangles& obstacles, const Chord& chord, double keep, double range)
{
  const double reach = range * (std::abs(chord.along.x) + std::abs(chord.along.y)) + keep;
  const Box window{std::min(chord.a.x, chord.b.x) - reach, std::min(chord.a.y, chord.b.y) - reach,
                   std::max(chord.a.x, chord.b.x) + reach, std::max(chord.a.y, chord.b.y) + reach};
  const std::array<HalfPlane, kRangePlanes> planes = range_planes(chord, range);
  Candidates candidates;
  obstacles.any_of(window, [&](const Box& rectangle) {
    const auto keeps = [&](const HalfPlane& plane) { return keeps_away(plane, rectangle, keep); };
    if (std::none_of(planes.begin(), planes.end(), keeps))
      candidates.push_back({rectangle, squared_distance(chord, rectangle)});
    return false;
  });
  return candidates;
}

const Candidate& nearest(const Candidates& candidates)
{
  return *std::min_element(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.squared_distance < b.squared_distance;
  });
}

/// Drops half-planes that do not touch the region.
void prune(const Chord& chord, double range, Polytope& planes)
{
  const double length = std::hypot(chord.b.x - chord.a.x, chord.b.y - chord.a.y);
  Polygon polygon(chord.a, 2.0 * (range + length));
  for (std::size_t i = 0; i < planes.size(); ++i) polygon.cut(planes[i], static_cast<int>(i));
  // If a region is so thin that rounding has removed its sides, it stays as it is.
  if (polygon.corners().size() < 3) return;
  Polytope kept;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (polygon.has_side(static_cast<int>(i))) kept.push_back(planes[i]);
  planes = std::move(kept);
}

}  // namespace

ChordRegion chord_region(const ObstacleRectangles& obstacles, const Chord& chord, double keep,
                         const PolytopeOptions& options)
{
  if (!obstacles.contains(chord.a) || !obstacles.contains(chord.b)) return {{}, keep};
  ChordRegion region;
  Candidates candidates = near(obstacles, chord, keep, options.range);
  const std::size_t most = static_cast<std::size_t>(options.max_half_planes) - kRangePlanes;
  while (!candidates.empty() && region.planes.size() < most)
  {
    const ClosestPoints closest = closest_points(chord, nearest(candidates).rectangle);
    const double distance = std::sqrt(closest.squared_distance), kept = std::min(keep, distance);
    if (distance < kTouches) return {{}, keep};
    region.deficit = std::max(region.deficit, keep - kept);

    const double nx = (closest.on_rectangle.x - closest.on_chord.x) / distance;
    const double ny = (closest.on_rectangle.y - closest.on_chord.y) / distance;
    const HalfPlane plane{nx, ny, nx * closest.on_rectangle.x + ny * closest.on_rectangle.y - kept};
    region.planes.push_back(plane);
    const auto is_kept_away = [&](const Candidate& c) { return keeps_away(plane, c.rectangle, kept); };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_kept_away), candidates.end());
  }

  double range = options.range;
  if (!candidates.empty())
  {
    const double distance = std::sqrt(nearest(candidates).squared_distance);
    if (distance < kTouches) return {{}, keep};
    region.deficit = std::max(region.deficit, keep - distance);
    range = std::min(range, std::max(0.0, distance - keep) * M_SQRT1_2);
  }
  const std::array<HalfPlane, kRangePlanes> sides = range_planes(chord, range);
  region.planes.insert(region.planes.end(), sides.begin(), sides.end());
  prune(chord, options.range, region.planes);
  return region;
}

}  // namespace fourwis
