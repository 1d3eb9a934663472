#include "page.h"

#include <cmath>
#include <cstdio>

namespace fourwis
{
namespace
{

constexpr double kMaxMapWidth = 1200.0, kMaxMapHeight = 900.0;
constexpr double kMinPageWidth = 900.0;  ///< what the legend needs
constexpr double kLegendHeight = 76.0;

}  // namespace

Page::Page(const ShownArea& shown) : extent(shown)
{
  const double metres_x = std::max(extent.max_x - extent.min_x, 1e-6);
  const double metres_y = std::max(extent.max_y - extent.min_y, 1e-6);
  scale = std::min(kMaxMapWidth / metres_x, kMaxMapHeight / metres_y);
  map_width = metres_x * scale;
  map_height = metres_y * scale;
  width = std::max(map_width, kMinPageWidth);
  height = map_height + kLegendHeight;
  left = (width - map_width) / 2.0;
}

std::string pixels(double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.2f", std::abs(value) < 0.005 ? 0.0 : value);
  std::string digits = text;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

std::string polyline(const Page& page, const std::vector<Point>& points, bool closed)
{
  std::string path;
  for (const Point& point : points)
  {
    const Point p = page.to_page(point);
    path += (path.empty() ? 'M' : 'L') + pixels(p.x) + ',' + pixels(p.y);
  }
  return path.empty() || !closed ? path : path + 'Z';
}

Point at_pose(const Pose& pose, double forward, double left)
{
  const Pose point = compose(pose, {forward, left, 0.0});
  return {point.x, point.y};
}

}  // namespace fourwis
