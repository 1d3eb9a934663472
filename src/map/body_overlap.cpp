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

/// One side of a convex outline, followed from its lowest corner to its highest.
class Side
{
public:
  /// Of corners that follow one another counter-clockwise: so do those of the right side, those of the left one the other way.
  Side(const Point2* corners, std::size_t count, std::size_t lowest, bool counter_clockwise)
    : corners_(corners),
      count_(count),
      counter_clockwise_(counter_clockwise),
      next_(lowest),
      left_(count)
  {
    u_ = corners_[lowest].x;
    advance();
  }

  /// Goes up to a height that is not below the one before, and adds where the side was on the way there.
  void follow(double height, Extent& covered)
  {
    covered.add(u_);
    while (left_ > 0 && corners_[next_].y <= height)
    {
      u_ = corners_[next_].x;
      covered.add(u_);
      advance();
    }
    if (left_ == 0) return;
    u_ = base_u_ + slope_ * (height - base_v_);
    covered.add(u_);
  }

private:
  /// To the edge that begins at the next corner.
  void advance()
  {
    const Point2& from = corners_[next_];
    next_ = counter_clockwise_ ? (next_ + 1 == count_ ? 0 : next_ + 1) : (next_ == 0 ? count_ - 1 : next_ - 1);
    --left_;
    base_u_ = from.x;
    base_v_ = from.y;
    const double rise = corners_[next_].y - from.y;
    if (rise < 0.0) left_ = 0;  // over the top
    slope_ = rise > 0.0 ? (corners_[next_].x - from.x) / rise : 0.0;
  }

  const Point2* corners_;
  const std::size_t count_;
  const bool counter_clockwise_;
  std::size_t next_, left_;  ///< the corner ahead, and how many there are
  double u_;                 ///< where the side is now
  double base_u_ = 0.0, base_v_ = 0.0, slope_ = 0.0;
};

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
      if (corner.y < along_.least) lowest_ = i;
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
    int row = static_cast<int>(std::floor(std::max(0.0, along_.least + kTouch)));
    Side left(corners_.data(), count_, lowest_, false), right(corners_.data(), count_, lowest_, true);
    Extent below;
    if (row > along_.least) left.follow(row, below), right.follow(row, below);
    for (; row <= last_row; ++row)
    {
      Extent covered;
      left.follow(row + 1.0, covered);
      right.follow(row + 1.0, covered);
      const int first = static_cast<int>(std::floor(std::max(0.0, covered.least + kTouch)));
      const int last = static_cast<int>(std::ceil(std::min<double>(map.width(), covered.greatest) - kTouch)) - 1;
      if (first <= last && !visit(row, first, last)) return;
    }
  }

private:
  std::array<Point2, kCorners> corners_;
  std::size_t count_, lowest_ = 0;
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
  outline.for_rows(map, [&](int row, int first, int last) { return clear = map.is_free_row(first, last, row); });
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
