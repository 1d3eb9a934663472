#pragma once

#include "fourwis_navigation/corridor/obstacle_rectangles.h"

namespace fourwis
{

/// Where a disc centre moves over one interval: the segment from a to b.
struct Chord
{
  Chord(const Point2& from, const Point2& to);

  Point2 a, b;
  Point2 along;            ///< unit vector from a to b; x where the two are one
  double inverse_squared;  ///< 1 / |b - a|^2, or 0 where the two are one [1/m^2]

  /// The point of the chord nearest to `point`.
  Point2 nearest(const Point2& point) const;
};

/// The point of a rectangle nearest to `point`.
Point2 nearest(const Box& rectangle, const Point2& point);

/// The nearest points of a chord and a rectangle.
struct ClosestPoints
{
  Point2 on_chord, on_rectangle;
  double squared_distance;  ///< [m^2]; 0 where the chord meets the rectangle
};

ClosestPoints closest_points(const Chord& chord, const Box& rectangle);

/// closest_points().squared_distance, faster.
double squared_distance(const Chord& chord, const Box& rectangle);

/// The least of x n_x + y n_y over a rectangle.
inline double least_along(const Box& rectangle, double normal_x, double normal_y)
{
  return normal_x * (normal_x > 0.0 ? rectangle.x_min : rectangle.x_max) +
         normal_y * (normal_y > 0.0 ? rectangle.y_min : rectangle.y_max);
}

}  // namespace fourwis
