#include "configuration_space.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/map/body_overlap.h"

namespace fourwis
{
namespace
{

/// The slices of the body with its margin, its sides moved outward by `more` [m].
HeadingSlices slices(const CollisionChecker& checker, double spacing, double more, const Interrupt& interrupt)
{
  const ObstacleMap& map = checker.map();
  HeadingSlices result(map, spacing, grown(checker.body_with_margin(), more), interrupt);
  // Near a tight spot less margin is enough.
  for (const CollisionChecker::TightSpot& spot : checker.tight_spots())
  {
    const Pose in_grid = relative_to(map.origin(), {spot.x, spot.y, 0.0});
    const ConvexPolygon body = grown(spot.with_margin, more);
    const double radius = CollisionChecker::TightSpot::kRadius + std::max(0.0, -more);
    const int reach = static_cast<int>(radius / spacing);
    const int column = static_cast<int>(std::lround(in_grid.x / spacing));
    const int row = static_cast<int>(std::lround(in_grid.y / spacing));
    for (int j = std::max(0, row - reach); j <= std::min(result.rows() - 1, row + reach); ++j)
      for (int i = std::max(0, column - reach); i <= std::min(result.columns() - 1, column + reach); ++i)
      {
        const Pose point = compose(map.origin(), {i * spacing, j * spacing, 0.0});
        if (std::hypot(point.x - spot.x, point.y - spot.y) > radius) continue;
        HeadingSet free = 0;
        for (int k = 0; k < kHeadings; ++k)
          if (body.empty() || is_clear(map, body, placed({point.x, point.y, heading_of(k)}))) free |= heading_bit(k);
        result.add(i, j, free);
      }
  }
  return result;
}

}  // namespace

HeadingSlices free_headings(const CollisionChecker& checker, double spacing, const Interrupt& interrupt)
{
  return slices(checker, spacing, 0.0, interrupt);
}

/// No point of the body is farther from where it is at the point and the heading than by half the diagonal of a square of the
/// lattice and the chord of half a bin. Between two checked poses the checker lets the body come closer by half a stride.
HeadingSlices possibly_free_headings(const CollisionChecker& checker, double spacing, const Interrupt& interrupt)
{
  const double reach = reach_of(checker.body_with_margin());
  const double anywhere = M_SQRT1_2 * spacing + 2.0 * reach * std::sin(kBin / 4.0);
  return slices(checker, spacing, -anywhere - checker.stride() / 2.0, interrupt);
}

}  // namespace fourwis
