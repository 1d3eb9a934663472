#pragma once

#include <gtest/gtest.h>

#include "corridor_fixture.h"
#include "fourwis_navigation/corridor/polytope_corridor.h"

namespace fourwis
{

inline constexpr double kRounding = 1e-9;
inline const DiscCover kDiscs = disc_cover(Robot(), 2), kManyDiscs = disc_cover(Robot(), 5);

inline double excess(const HalfPlane& plane, const Pose& point)
{
  return plane.a * point.x + plane.b * point.y - plane.c;
}

/// Greatest distance by which a point lies outside a region; negative inside.
inline double excess(const Polytope& region, const Pose& point)
{
  double most = -INFINITY;
  for (const HalfPlane& plane : region) most = std::max(most, excess(plane, point));
  return most;
}

inline Pose between(const Pose& a, const Pose& b, double t)
{
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0.0};
}

/// One region and the chord it is about.
struct Case
{
  const Polytope& region;
  Pose from, to;
  double keep;     ///< r_c + shrink
  double deficit;  ///< of the interval
};

/// Visits the regions of all discs, interval by interval.
template <typename Visit>
void for_each_region(const PolytopeCorridor& corridor, const std::vector<Pose>& knots,
                     const std::vector<double>& shrink, Visit visit, const DiscCover& discs = kDiscs)
{
  ASSERT_EQ(corridor.status, CorridorStatus::succeeded) << corridor.message;
  ASSERT_EQ(corridor.regions.size(), discs.centres.size());
  for (const DiscRegions& disc : corridor.regions) ASSERT_EQ(disc.regions.size(), knots.size() - 1);
  ASSERT_EQ(corridor.deficit.size(), knots.size() - 1);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (std::size_t d = 0; d < discs.centres.size(); ++d)
    {
      SCOPED_TRACE("interval " + std::to_string(i) + ", disc " + std::to_string(d));
      EXPECT_EQ(corridor.regions[d].centre.x, discs.centres[d].x);
      EXPECT_EQ(corridor.regions[d].centre.y, discs.centres[d].y);
      visit(Case{corridor.regions[d].regions[i], disc_centre(knots[i], discs.centres[d]),
                 disc_centre(knots[i + 1], discs.centres[d]), discs.radius + (shrink.empty() ? 0.0 : shrink[i]),
                 corridor.deficit[i]});
      if (testing::Test::HasFailure()) return;
    }
}

/// Points of a region: its corners, along its sides and inside.
inline std::vector<Point2> sample(Random& random, const Case& c)
{
  const std::vector<Point2> ends = corners(c.region, {c.from.x, c.from.y}, 50.0);
  std::vector<Point2> points = ends;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (int k = 1; k < 8; ++k)
    {
      const Point2 &a = ends[i], &b = ends[(i + 1) % ends.size()];
      const Point2 side{a.x + (b.x - a.x) * k / 8.0, a.y + (b.y - a.y) * k / 8.0};
      points.push_back(side);
      const Pose on_chord = between(c.from, c.to, random.between(0.0, 1.0));
      const Pose inside = between({side.x, side.y, 0.0}, on_chord, random.between(0.0, 1.0));
      points.push_back({inside.x, inside.y});
    }
  return points;
}

/// The region holds its chord.
inline void expect_chord_inside(const Case& c)
{
  for (double t : {0.0, 0.3, 0.5, 1.0}) EXPECT_LE(excess(c.region, between(c.from, c.to, t)), kRounding) << "t " << t;
}

/// Points all over the region are as far from every obstacle as promised.
inline void expect_distance_kept(Random& random, const Scene& scene, const Case& c)
{
  const std::vector<Point2> points = sample(random, c);
  ASSERT_GE(points.size(), 3u);
  for (const Point2& p : points)
    ASSERT_GE(scene.every.distance(p.x, p.y), c.keep - c.deficit - kRounding) << p.x << " " << p.y;
}

}  // namespace fourwis
