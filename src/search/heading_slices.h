#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fourwis_navigation/map/obstacle_map.h"
#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/vehicle/body.h"

namespace fourwis
{

/// Headings of a whole turn, one bit each.
inline constexpr int kHeadings = 64;
using HeadingSet = std::uint64_t;
inline constexpr HeadingSet kAllHeadings = ~HeadingSet{0};
inline constexpr double kBin = 2.0 * M_PI / kHeadings;  ///< [rad]

inline double heading_of(int bin)
{
  return bin * kBin;
}

/// The nearest of them.
inline int heading_bin(double theta)
{
  const double bins = theta / kBin;
  return static_cast<int>(std::lround(bins - kHeadings * std::floor(bins / kHeadings))) % kHeadings;
}

inline HeadingSet heading_bit(int bin)
{
  return HeadingSet{1} << bin;
}

/// The headings next to those of a set.
inline HeadingSet turned_by_one_bin(HeadingSet set)
{
  constexpr int last = kHeadings - 1;
  return set << 1 | set >> last | set >> 1 | set << last;
}

/// At which headings a body is clear with C, the centre of the wheels, at each point of a lattice: its configuration space in
/// slices of one heading. The points (i, j) lie at (i, j) times the spacing from the grid's origin, along its axes.
class HeadingSlices
{
public:
  /// If interrupted it stops early, and the result is not usable.
  HeadingSlices(const ObstacleMap& map, double spacing, const ConvexPolygon& body, const Interrupt& interrupt);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double spacing() const { return spacing_; }

  /// None for points outside.
  HeadingSet at(int i, int j) const { return i < 0 || j < 0 || i >= columns_ || j >= rows_ ? 0 : clear_[index(i, j)]; }
  void add(int i, int j, HeadingSet headings) { clear_[index(i, j)] |= headings; }

private:
  std::size_t index(int i, int j) const
  {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }

  double spacing_;
  int columns_, rows_;
  std::vector<HeadingSet> clear_;
};

}  // namespace fourwis
