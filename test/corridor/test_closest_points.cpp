#include "corridor/closest_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/random.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 11;

double length(const Point2& a, const Point2& b)
{
  return std::hypot(a.x - b.x, a.y - b.y);
}

struct RandomPairs : testing::Test
{
  /// Chords and rectangles on a coarse lattice, where they often touch, cross, are parallel or have no length, and off
  /// it.
  template <typename Visit>
  void for_pairs(Visit visit)
  {
    for (int k = 0; k < 20000; ++k)
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", pair " + std::to_string(k));
      const auto number = [&] { return k % 2 == 0 ? random.whole(-4, 4) * 0.5 : random.between(-2.0, 2.0); };
      const Box box{-0.5 * random.whole(1, 3), -0.5 * random.whole(1, 3), 0.5 * random.whole(1, 3), 0.5};
      visit(Chord({number(), number()}, {number(), number()}), box);
      if (HasFailure()) return;
    }
  }

  Random random{kSeed};
};

TEST_F(RandomPairs, NoPointsOfChordAndRectangleAreNearer)
{
  for_pairs([](const Chord& chord, const Box& box) {
    const ClosestPoints closest = closest_points(chord, box);
    double sampled = INFINITY;
    for (int i = 0; i <= 1000; ++i)
    {
      const double t = i / 1000.0;
      const Point2 p{chord.a.x + (chord.b.x - chord.a.x) * t, chord.a.y + (chord.b.y - chord.a.y) * t};
      sampled = std::min(sampled, length(p, nearest(box, p)));
    }
    const double distance = std::sqrt(closest.squared_distance);
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GE(distance, sampled - 0.003);  // half a step
    EXPECT_EQ(squared_distance(chord, box), closest.squared_distance);
  });
}

TEST_F(RandomPairs, TheLineAcrossBetweenThePointsSeparatesChordAndRectangle)
{
  for_pairs([](const Chord& chord, const Box& box) {
    const ClosestPoints closest = closest_points(chord, box);
    const double distance = std::sqrt(closest.squared_distance);
    if (distance < 1e-6) return;
    EXPECT_NEAR(length(closest.on_chord, closest.on_rectangle), distance, 1e-12);
    const double nx = (closest.on_rectangle.x - closest.on_chord.x) / distance;
    const double ny = (closest.on_rectangle.y - closest.on_chord.y) / distance;
    const double at_chord = nx * closest.on_chord.x + ny * closest.on_chord.y;
    EXPECT_LE(nx * chord.a.x + ny * chord.a.y, at_chord + 1e-9);
    EXPECT_LE(nx * chord.b.x + ny * chord.b.y, at_chord + 1e-9);
    EXPECT_NEAR(least_along(box, nx, ny), at_chord + distance, 1e-9);
  });
}

}  // namespace
}  // namespace fourwis
