#include "polygon.h"

#include <algorithm>

namespace fourwis
{
namespace
{

/// Corners that are outside by less than this stay where they are [m].
constexpr double kRounding = 1e-12;

double excess(const HalfPlane& plane, const Point2& point)
{
  return plane.a * point.x + plane.b * point.y - plane.c;
}

}  // namespace

Polygon::Polygon(const Point2& centre, double half_side)
  : corners_{{{centre.x - half_side, centre.y - half_side}, -1},
             {{centre.x + half_side, centre.y - half_side}, -1},
             {{centre.x + half_side, centre.y + half_side}, -1},
             {{centre.x - half_side, centre.y + half_side}, -1}}
{}

void Polygon::cut(const HalfPlane& plane, int name)
{
  next_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i)
  {
    const Corner &from = corners_[i], &to = corners_[(i + 1) % corners_.size()];
    const double before = excess(plane, from.at), after = excess(plane, to.at);
    const bool begins_inside = before <= kRounding, ends_inside = after <= kRounding;
    if (begins_inside) next_.push_back(from);
    if (begins_inside == ends_inside) continue;
    const double t = before / (before - after);
    const Point2 crossing{from.at.x + t * (to.at.x - from.at.x), from.at.y + t * (to.at.y - from.at.y)};
    next_.push_back({crossing, begins_inside ? name : from.side});
  }
  corners_.swap(next_);
}

bool Polygon::has_side(int name) const
{
  return std::any_of(corners_.begin(), corners_.end(), [&](const Corner& corner) { return corner.side == name; });
}

std::vector<Point2> Polygon::corners() const
{
  std::vector<Point2> points;
  for (const Corner& corner : corners_) points.push_back(corner.at);
  return points;
}

}  // namespace fourwis
