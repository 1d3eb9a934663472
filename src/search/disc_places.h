#pragma once

#include <cstdint>
#include <vector>

#include "fourwis_navigation/map/obstacle_map.h"
#include "fourwis_navigation/model/interrupt.h"

namespace fourwis
{

/// Where the centre of a disc may be on a map. In a gap that is too narrow the nearest such place is far away, even if
/// the gap is too narrow by millimetres only, because on the way through the clearance falls with the square of the
/// distance. The simple bound of the clearance in a cell, the clearance at its centre plus half the diagonal, does not
/// show that.
class DiscPlaces
{
public:
  /// Places with at least that clearance [m], as squares of the given side [m] that may hold one. If interrupted it
  /// stops early, and the result is not usable.
  DiscPlaces(const ObstacleMap& map, double clearance, double square, const Interrupt& interrupt);

  /// Whether there may be a place in a rectangle along the map's axes, `reach_x` and `reach_y` to either side of a point of
  /// the map frame. False is certain.
  bool any_near(double x, double y, double reach_x, double reach_y) const;

private:
  void mark(int column, int row, int squares, double clearance);
  void sum_up();

  /// Places in the squares below and left of a corner.
  std::uint32_t& sum(int column, int row) { return sums_[index(column, row)]; }
  std::uint32_t sum(int column, int row) const { return sums_[index(column, row)]; }
  std::size_t index(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_ + 1) + static_cast<std::size_t>(column);
  }

  const ObstacleMap& map_;
  double square_;
  int width_, height_;
  std::vector<std::uint32_t> sums_;
};

}  // namespace fourwis
