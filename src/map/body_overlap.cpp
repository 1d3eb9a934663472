#include "fourwis_navigation/map/body_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fourwis
{
namespace
{

/// Overlaps of this depth are still a touch [cells].
constexpr double kTouch = 1e-7;
/// To this accuracy the clearance of a body is found [m].
constexpr double kAccuracy = 1e-6;
/// Corners of a body that are kept without asking for memory.
constexpr std::size_t kCorners = 64;

/// A body at a pose, in cells.
class Outline
{
public:
  Outline(const ObstacleMap& map, const ConvexPolygon& body, const Placed& place) : count_(body.size())
  {
    if (count_ > kCorners) throw std::length_error("a body has " + std::to_string(count_) + " corners, at most 64");
    for (std::size_t i = 0; i < count_; ++i)
    {
      const Point2& p = body[i];
      Point2& corner = corners_[i];
      map.to_cells(place.x + p.x * place.cosine - p.y * place.sine, place.y + p.x * place.sine + p.y * place.cosine,
                   corner.x, corner.y);
      across_.add(corner.x);
      along_.add(corner.y);
    }
  }

  /// False for NaN, which leaves the spans empty.
  bool lies_in(const ObstacleMap& map) const
  {
    return across_.least <= across_.greatest && along_.least <= along_.greatest && across_.least >= -kTouch &&
           along_.least >= -kTouch && across_.greatest <= map.width() + kTouch &&
           along_.greatest <= map.height() + kTouch;
  }

  /// Calls visit(row, first column, last column) for the cells of the grid that the body overlaps, as long as it returns true.
  template <typename Visit>
  void for_rows(const ObstacleMap& map, Visit visit) const
  {
    if (!(across_.least <= map.width() && across_.greatest >= 0.0)) return;
    const double top = std::min(along_.greatest, static_cast<double>(map.height()));
    const int last_row = static_cast<int>(std::ceil(top - kTouch)) - 1;
    for (int row = static_cast<int>(std::floor(std::max(0.0, along_.least + kTouch))); row <= last_row; ++row)
    {
      const Extent covered = extent_between(corners_.data(), count_, row, row + 1.0);
      const int first = static_cast<int>(std::floor(std::max(0.0, covered.least + kTouch)));
      const int last = static_cast<int>(std::ceil(std::min<double>(map.width(), covered.greatest) - kTouch)) - 1;
      if (first <= last && !visit(row, first, last)) return;
    }
  }

private:
  std::array<Point2, kCorners> corners_;
  std::size_t count_;
  Extent across_, along_;  ///< all of it, in columns and in rows
};

}  // namespace

Placed placed(const Pose& pose)
{
  return {pose.x, pose.y, std::cos(pose.theta), std::sin(pose.theta)};
}

bool is_clear(const ObstacleMap& map, const ConvexPolygon& body, const Placed& place)
{
  const Outline outline(map, body, place);
  if (!outline.lies_in(map)) return false;
  bool clear = true;
  outline.for_rows(map, [&](int row, int first, int last) { return clear = map.next_obstacle(first, row) > last; });
  return clear;
}

bool lies_in(const ObstacleMap& map, const ConvexPolygon& body, const Pose& pose)
{
  return Outline(map, body, placed(pose)).lies_in(map);
}

std::vector<CellIndex> overlapped_cells(const ObstacleMap& map, const ConvexPolygon& body, const Pose& pose)
{
  std::vector<CellIndex> cells;
  Outline(map, body, placed(pose)).for_rows(map, [&](int row, int first, int last) {
    for (int column = first; column <= last; ++column) cells.push_back({column, row});
    return true;
  });
  return cells;
}

double body_clearance(const ObstacleMap& map, const ConvexPolygon& body, const Pose& pose, double most)
{
  const Placed place = placed(pose);
  double clear = -reach_of(body), overlapping = most;
  if (is_clear(map, grown(body, most), place)) return most;
  if (is_clear(map, body, place))
    clear = 0.0;
  else
    overlapping = 0.0;
  while (overlapping - clear > kAccuracy)
  {
    const double middle = (clear + overlapping) / 2.0;
    const ConvexPolygon changed = grown(body, middle);
    (changed.empty() || is_clear(map, changed, place) ? clear : overlapping) = middle;
  }
  return grown(body, clear).empty() ? -std::numeric_limits<double>::infinity() : clear;
}

}  // namespace fourwis
