#include "fourwis_navigation/search/search.h"
#include "fourwis_navigation/segment/segment.h"
#include "polytope_laws.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 3;

/// Drives about random maps.
struct RandomDrives : testing::Test
{
  template <typename Visit>
  void for_drives(Visit visit, double spacing = 0.2)
  {
    for (int k = 0; k < 48; ++k)
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", drive " + std::to_string(k));
      const Scene scene(corridor_grid(random, k));
      visit(scene, random_knots(random, scene.site.checker, scene.site.robot, spacing));
      if (HasFailure()) return;
    }
  }

  Random random{kSeed};
};

TEST_F(RandomDrives, RegionsHoldTheirChordsAndKeepTheirDistance)
{
  for_drives([&](const Scene& scene, const std::vector<Pose>& knots) {
    const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kDiscs, {}, knots);
    for_each_region(corridor, knots, {}, [&](const Case& c) {
      expect_chord_inside(c);
      expect_distance_kept(random, scene, c);
    });
  });
}

TEST_F(RandomDrives, SoDoTheRegionsOfMoreDiscs)
{
  for_drives([&](const Scene& scene, const std::vector<Pose>& knots) {
    const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kManyDiscs, {}, knots);
    // Not all of these discs are within the two that the drives are free for: some meet obstacles.
    if (corridor.status != CorridorStatus::succeeded) return;
    for_each_region(
        corridor, knots, {},
        [&](const Case& c) {
          expect_chord_inside(c);
          expect_distance_kept(random, scene, c);
        },
        kManyDiscs);
  });
}

TEST_F(RandomDrives, RegionsHoldTheirChordsAndKeepTheirDistanceWithFewHalfPlanes)
{
  for_drives([&](const Scene& scene, const std::vector<Pose>& knots) {
    PolytopeOptions options;
    options.max_half_planes = random.whole(4, 7);
    const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kDiscs, options, knots);
    for_each_region(corridor, knots, {}, [&](const Case& c) {
      EXPECT_LE(c.region.size(), static_cast<std::size_t>(options.max_half_planes));
      expect_chord_inside(c);
      expect_distance_kept(random, scene, c);
    });
  });
}

TEST_F(RandomDrives, RegionsShrinkAsFarAsTheirChordsAllow)
{
  for_drives([&](const Scene& scene, const std::vector<Pose>& knots) {
    std::vector<double> shrink(knots.size() - 1);
    for (double& s : shrink) s = random.chance(0.3) ? 0.0 : random.between(0.0, 0.3);
    const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kDiscs, {}, knots, shrink);
    for_each_region(corridor, knots, shrink, [&](const Case& c) {
      expect_chord_inside(c);
      expect_distance_kept(random, scene, c);
    });
  });
}

TEST_F(RandomDrives, TheDeficitIsWhatTheChordLacks)
{
  // Long intervals, whose chords come closer than their arcs.
  double greatest = 0.0;
  for_drives(
      [&](const Scene& scene, const std::vector<Pose>& knots) {
        const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kDiscs, {}, knots);
        for (std::size_t i = 0; i + 1 < knots.size(); ++i)
        {
          double nearest = INFINITY;
          for (const Point2& on_body : kDiscs.centres)
            for (int k = 0; k <= 500; ++k)
            {
              const Pose p = between(disc_centre(knots[i], on_body), disc_centre(knots[i + 1], on_body), k / 500.0);
              nearest = std::min(nearest, scene.every.distance(p.x, p.y));
            }
          ASSERT_NEAR(corridor.deficit[i], std::max(0.0, kDiscs.radius - nearest), 1e-3) << "interval " << i;
          greatest = std::max(greatest, corridor.deficit[i]);
        }
      },
      0.8);
  EXPECT_GT(greatest, 0.01) << "no case of interest";
}

TEST_F(RandomDrives, EveryHalfPlaneIsAsFarOutAsAnObstacleOrTheRangeAllows)
{
  for_drives([&](const Scene& scene, const std::vector<Pose>& knots) {
    PolytopeOptions options;
    options.max_half_planes = 200;
    const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kDiscs, options, knots);
    for_each_region(corridor, knots, {}, [&](const Case& c) {
      for (const HalfPlane& plane : c.region)
      {
        EXPECT_NEAR(std::hypot(plane.a, plane.b), 1.0, 1e-12);
        const double beyond_chord = -std::max(excess(plane, c.from), excess(plane, c.to));
        const bool is_range = std::abs(beyond_chord - options.range) < kRounding;
        const bool is_chord = std::abs(beyond_chord) < kRounding && c.deficit > 0.0;
        EXPECT_TRUE(is_range || is_chord || scene.every.touches(plane, c.keep, 1e-6)) << beyond_chord;
      }
    });
  });
}

TEST_F(RandomDrives, RegionsReachNoFurtherThanTheRange)
{
  for_drives([&](const Scene& scene, const std::vector<Pose>& knots) {
    PolytopeOptions options;
    options.range = random.between(0.1, 3.0);
    const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kDiscs, options, knots);
    for_each_region(corridor, knots, {}, [&](const Case& c) {
      for (const Point2& end : corners(c.region, {c.from.x, c.from.y}, 50.0))
      {
        const double heading = std::atan2(c.to.y - c.from.y, c.to.x - c.from.x);
        const Pose seen = relative_to({c.from.x, c.from.y, heading}, {end.x, end.y, 0.0});
        EXPECT_LE(std::abs(seen.y), options.range + kRounding);
        EXPECT_GE(seen.x, -options.range - kRounding);
        EXPECT_LE(seen.x, distance(c.from, c.to) + options.range + kRounding);
      }
    });
  });
}

TEST_F(RandomDrives, NoHalfPlaneIsUseless)
{
  for_drives([&](const Scene& scene, const std::vector<Pose>& knots) {
    const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kDiscs, {}, knots);
    for_each_region(corridor, knots, {}, [&](const Case& c) {
      const std::vector<Point2> ends = corners(c.region, {c.from.x, c.from.y}, 50.0);
      for (const HalfPlane& plane : c.region)
        EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [&](const Point2& end) {
          return std::abs(excess(plane, {end.x, end.y, 0.0})) < kRounding;
        }));
    });
  });
}

/// Area of a region around a pose [m^2].
double area(const Polytope& region, const Pose& centre)
{
  const std::vector<Point2> ends = corners(region, {centre.x, centre.y}, 50.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const Point2 &p = ends[i], &q = ends[(i + 1) % ends.size()];
    sum += ((p.x - centre.x) * (q.y - centre.y) - (q.x - centre.x) * (p.y - centre.y)) / 2.0;
  }
  return sum;
}

TEST_F(RandomDrives, AMapThatIsMovedAndTurnedMovesAndTurnsTheRegions)
{
  for_drives([&](const Scene& scene, const std::vector<Pose>& knots) {
    OccupancyGrid moved_grid = scene.site.grid;
    const Pose motion = random.pose(10.0);
    moved_grid.origin = compose(motion, scene.site.grid.origin);
    std::vector<Pose> moved_knots;
    for (const Pose& knot : knots) moved_knots.push_back(compose(motion, knot));
    const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kDiscs, {}, knots);
    const ObstacleRectangles moved_obstacles{ObstacleMap(moved_grid)};
    const PolytopeCorridor moved = polytope_corridor(moved_obstacles, kDiscs, {}, moved_knots);
    for_each_region(moved, moved_knots, {}, expect_chord_inside);
    // Ties may be broken otherwise by rounding, so areas are compared, not half-planes.
    double before = 0.0, after = 0.0;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    {
      before += area(corridor.regions[0].regions[i], knots[i]);
      after += area(moved.regions[0].regions[i], moved_knots[i]);
    }
    EXPECT_NEAR(after, before, 0.02 * before);
  });
}

TEST(PolytopePaths, PathsOfTheSearchGetRegionsWithHardlyADeficit)
{
  Random random(kSeed);
  int paths = 0;
  for (int k = 0; k < 12; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", path " + std::to_string(k));
    const Scene scene(corridor_grid(random, k));
    PlanRequest request;
    request.start = free_pose(random, scene.site.checker);
    request.goal = free_pose(random, scene.site.checker);
    const SearchResult found = Search({scene.site.checker, request.start, request.goal}).find({}, request.modes);
    if (found.status != PlanStatus::succeeded) continue;
    ++paths;
    // An arc's sagitta at the greatest curvature, and what the search's checks may miss between poses.
    const double sagitta = 0.2 * 0.2 / 8.0 * max_curvature(scene.site.robot, Mode::lateral);
    const double allowed = sagitta + scene.site.checker.stride() / 2.0;
    for (const Segment& segment : split_at_switches(found.path, scene.site.robot, 0.2))
    {
      const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kDiscs, {}, segment.knots);
      for_each_region(corridor, segment.knots, {}, [&](const Case& c) {
        expect_chord_inside(c);
        expect_distance_kept(random, scene, c);
        EXPECT_LE(c.deficit, allowed);
      });
    }
  }
  EXPECT_GE(paths, 8);
}

}  // namespace
}  // namespace fourwis
