#pragma once

#include "../../support/grids.h"

namespace fourwis::nightly
{

/// Draws obstacles on a grid in metres. What lies outside is left out.
class Drawing
{
public:
  Drawing(double length, double width, double resolution) : grid_(free_area(length, width, resolution)) {}

  double length() const { return grid_.width * grid_.resolution; }
  double width() const { return grid_.height * grid_.resolution; }

  /// A box from one corner to another; where it has any size, it has a cell.
  void box(double left, double bottom, double right, double top, bool occupied = true);

  /// The same, free.
  void opening(double left, double bottom, double right, double top) { box(left, bottom, right, top, false); }

  /// A rectangle of any heading: the cells whose centre it covers.
  void rectangle(const Pose& middle, double length, double width);

  void disc(double x, double y, double radius);

  /// A wall around the whole.
  void frame(double thickness);

  const OccupancyGrid& grid() const { return grid_; }

private:
  OccupancyGrid grid_;
};

}  // namespace fourwis::nightly
