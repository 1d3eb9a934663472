#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// A point on a page or in the map frame.
struct Point
{
  double x = 0.0, y = 0.0;
};

/// The part of the map frame that a picture shows [m].
struct ShownArea
{
  double min_x = std::numeric_limits<double>::max(), min_y = std::numeric_limits<double>::max();
  double max_x = std::numeric_limits<double>::lowest(), max_y = std::numeric_limits<double>::lowest();

  void include(const Point& point)
  {
    min_x = std::min(min_x, point.x);
    min_y = std::min(min_y, point.y);
    max_x = std::max(max_x, point.x);
    max_y = std::max(max_y, point.y);
  }
};

/// Where the map lies on the page: pixels, x to the right, y down, map above, legend below.
struct Page
{
  explicit Page(const ShownArea& extent);

  Point to_page(const Point& map) const
  {
    return {left + (map.x - extent.min_x) * scale, (extent.max_y - map.y) * scale};
  }

  ShownArea extent;
  double scale = 1.0;  ///< pixels a metre
  double left = 0.0;   ///< where the map begins, to the left of which there is a margin
  double map_width = 0.0, map_height = 0.0;
  double width = 0.0, height = 0.0;  ///< of the whole page
};

/// A number with at most two decimals.
std::string pixels(double value);

/// "M x,y L x,y ..." through points of the map frame; nothing when there are none.
std::string polyline(const Page& page, const std::vector<Point>& points, bool closed);

/// A point of the body frame at a pose, in the map frame.
Point at_pose(const Pose& pose, double forward, double left);

}  // namespace fourwis
