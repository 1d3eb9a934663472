#include "fourwis_navigation/vehicle/footprint.h"

#include "fourwis_navigation/vehicle/body.h"

namespace fourwis
{
namespace
{

/// By this share the discs within a footprint are smaller than the largest disc, so that there is room for two.
constexpr double kSmaller = 0.02;
/// To this share of it the largest disc is found.
constexpr double kAccuracy = 1e-4;

/// Radius of the largest disc within a polygon [m].
double largest_radius(const ConvexPolygon& polygon)
{
  double fits = 0.0, does_not = reach_of(polygon);
  while (does_not - fits > kAccuracy * does_not)
  {
    const double radius = (fits + does_not) / 2.0;
    (grown(polygon, -radius).empty() ? does_not : fits) = radius;
  }
  return fits;
}

/// The discs' centres are where the polygon, its sides moved inward by the radius, is longest at half its height.
TwoDiscs discs_within(const ConvexPolygon& polygon)
{
  const double radius = (1.0 - kSmaller) * largest_radius(polygon);
  const ConvexPolygon places = grown(polygon, -radius);
  if (places.empty()) return {0.0, 0.0};
  Extent y;
  for (const Point2& place : places) y.add(place.y);
  const double middle = (y.least + y.greatest) / 2.0;
  const Extent x = extent_between(places.data(), places.size(), middle, middle);
  return {(x.greatest - x.least) / 2.0, radius, {(x.least + x.greatest) / 2.0, middle}};
}

}  // namespace

TwoDiscs two_discs(const Robot& robot)
{
  const BodyBox box = box_of(robot);
  const double offset = box.length / 4.0;
  return {offset, std::hypot(offset, box.width / 2.0) + robot.safety_margin, box.middle};
}

TwoDiscs inscribed_discs(const Robot& robot, double margin)
{
  if (robot.footprint.empty())
    return {std::max(0.0, robot.length - robot.width) / 2.0, std::min(robot.length, robot.width) / 2.0 + margin,
            robot.body_offset};
  TwoDiscs discs = discs_within(body_of(robot));
  discs.radius += margin;
  return discs;
}

DiscCover disc_cover(const Robot& robot, int along, int across)
{
  const ConvexPolygon body = body_of(robot);
  const BodyBox box = box_of(robot);
  const double length = box.length / along;
  DiscCover cover{{}, 0.0};
  // Along x, which extent_between() does along y.
  ConvexPolygon turned;
  for (const Point2& corner : body) turned.push_back({corner.y, corner.x});
  double widest = 0.0;
  for (int i = 0; i < along; ++i)
  {
    const double x = box.middle.x + ((box.length - length) / 2.0 - i * length);
    const Extent y = extent_between(turned.data(), turned.size(), x - length / 2.0, x + length / 2.0);
    const double strip = robot.footprint.empty() ? box.width : y.greatest - y.least, width = strip / across;
    const double middle = robot.footprint.empty() ? box.middle.y : (y.least + y.greatest) / 2.0;
    widest = std::max(widest, width);
    for (int j = 0; j < across; ++j) cover.centres.push_back({x, middle + ((strip - width) / 2.0 - j * width)});
  }
  cover.radius = std::hypot(length, widest) / 2.0 + robot.safety_margin;
  return cover;
}

}  // namespace fourwis
