#include "configuration_space.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/map/body_overlap.h"

namespace fourwis
{
HeadingSlices free_headings(const CollisionChecker& checker, double spacing, const Interrupt& interrupt)
{
  const ObstacleMap& map = checker.map();
  HeadingSlices result(map, spacing, checker.body_with_margin(), interrupt);
  // Near a tight spot less margin is enough.
  for (const CollisionChecker::TightSpot& spot : checker.tight_spots())
  {
    const Pose in_grid = relative_to(map.origin(), {spot.x, spot.y, 0.0});
    const int reach = static_cast<int>(CollisionChecker::TightSpot::kRadius / spacing);
    const int column = static_cast<int>(std::lround(in_grid.x / spacing));
    const int row = static_cast<int>(std::lround(in_grid.y / spacing));
    for (int j = std::max(0, row - reach); j <= std::min(result.rows() - 1, row + reach); ++j)
      for (int i = std::max(0, column - reach); i <= std::min(result.columns() - 1, column + reach); ++i)
      {
        const Pose point = compose(map.origin(), {i * spacing, j * spacing, 0.0});
        if (!spot.is_near(point.x, point.y)) continue;
        HeadingSet free = 0;
        for (int k = 0; k < kHeadings; ++k)
          if (is_clear(map, spot.with_margin, placed({point.x, point.y, heading_of(k)}))) free |= heading_bit(k);
        result.add(i, j, free);
      }
  }
  return result;
}

}  // namespace fourwis
