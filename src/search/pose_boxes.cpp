#include "pose_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fourwis_navigation/map/body_overlap.h"

namespace fourwis
{
namespace
{

/// Side of the largest boxes, in sizes of the robot, and how many headings they tell apart.
constexpr double kLargest = 0.2;
constexpr int kTurns = 16;

}  // namespace

PoseBoxes::PoseBoxes(const CollisionChecker& checker) : checker_(checker)
{
  const ConvexPolygon& body = checker.body_with_margin();
  const double reach = reach_of(body);
  for (int level = 0; level < kLevels; ++level)
  {
    size_.push_back(kLargest * checker.robot().size() / (1 << level));
    turn_.push_back(2.0 * M_PI / (kTurns << level));
    reach_.push_back(M_SQRT1_2 * size_.back() + 2.0 * reach * std::sin(turn_.back() / 4.0));
  }
  shapes_ = shapes(body);
  for (const CollisionChecker::TightSpot& spot : checker.tight_spots())
    spots_.push_back({spot.x, spot.y, spot.margin, shapes(spot.with_margin)});
  const ObstacleMap& map = checker.map();
  columns_ = static_cast<int>(std::ceil(map.width() * map.resolution() / size_.front()));
  rows_ = static_cast<int>(std::ceil(map.height() * map.resolution() / size_.front()));
}

std::vector<PoseBoxes::Shape> PoseBoxes::shapes(const ConvexPolygon& body) const
{
  std::vector<Shape> shapes;
  // Between two checked poses the checker lets the body come closer by half a stride.
  for (double reach : reach_) shapes.push_back({grown(body, reach), grown(body, -reach - checker_.stride() / 2.0)});
  return shapes;
}

std::uint64_t PoseBoxes::key(const PoseBox& box)
{
  return static_cast<std::uint64_t>(box.i) | static_cast<std::uint64_t>(box.j) << 24 |
         static_cast<std::uint64_t>(box.k) << 48 | static_cast<std::uint64_t>(box.level) << 60;
}

Pose PoseBoxes::centre(const PoseBox& box) const
{
  const std::size_t level = static_cast<std::size_t>(box.level);
  const Pose in_grid = {(box.i + 0.5) * size_[level], (box.j + 0.5) * size_[level], (box.k + 0.5) * turn_[level]};
  return compose(checker_.map().origin(), in_grid);
}

PoseBox PoseBoxes::at(const Pose& pose) const
{
  const Pose in_grid = relative_to(checker_.map().origin(), pose);
  const double turns = in_grid.theta / (2.0 * M_PI);
  const double heading = (turns - std::floor(turns)) * 2.0 * M_PI;
  PoseBox box;
  for (box.level = 0; box.level < kLevels; ++box.level)
  {
    const std::size_t level = static_cast<std::size_t>(box.level);
    box.i = std::clamp(static_cast<int>(in_grid.x / size_[level]), 0, (columns_ << box.level) - 1);
    box.j = std::clamp(static_cast<int>(in_grid.y / size_[level]), 0, (rows_ << box.level) - 1);
    box.k = std::clamp(static_cast<int>(heading / turn_[level]), 0, (kTurns << box.level) - 1);
    if (!is_split(box)) break;
  }
  return box;
}

PoseBoxes::State PoseBoxes::state(const PoseBox& box)
{
  const auto [found, fresh] = states_.try_emplace(key(box), std::uint8_t{0});
  if (fresh)
  {
    ++looks_;
    found->second = static_cast<std::uint8_t>(look(box));
  }
  return static_cast<State>(found->second);
}

PoseBoxes::State PoseBoxes::look(const PoseBox& box) const
{
  const std::size_t level = static_cast<std::size_t>(box.level);
  const Placed place = placed(centre(box));
  const std::vector<Shape>* near = &shapes_;
  double margin = std::numeric_limits<double>::infinity();
  for (const Spot& spot : spots_)
  {
    if (spot.margin >= margin) continue;
    if (std::hypot(place.x - spot.x, place.y - spot.y) >= CollisionChecker::TightSpot::kRadius + reach_[level])
      continue;
    near = &spot.shapes;
    margin = spot.margin;
  }
  const ConvexPolygon &larger = shapes_[level].larger, &smaller = (*near)[level].smaller;
  const ObstacleMap& map = checker_.map();
  if (map.is_clear(place.x, place.y, reach_of(larger)) || is_clear(map, larger, place)) return State::free;
  return smaller.empty() || is_clear(map, smaller, place) ? State::mixed : State::blocked;
}

void PoseBoxes::split(const PoseBox& box)
{
  states_[key(box)] = kSplit;
}

void PoseBoxes::neighbours(const PoseBox& box, std::vector<PoseBox>& found) const
{
  found.clear();
  for (int axis = 0; axis < 3; ++axis)
    for (int side : {-1, 1})
    {
      PoseBox next = box;
      (axis == 0 ? next.i : axis == 1 ? next.j : next.k) += side;
      if (next.i < 0 || next.j < 0 || next.i >= columns_ << box.level || next.j >= rows_ << box.level) continue;
      const int turns = kTurns << box.level;
      next.k = (next.k + turns) % turns;
      // A larger box, if the one of this size is no part of a split one.
      PoseBox whole{0, next.i >> next.level, next.j >> next.level, next.k >> next.level};
      while (whole.level < next.level && is_split(whole))
      {
        ++whole.level;
        const int finer = next.level - whole.level;
        whole.i = next.i >> finer;
        whole.j = next.j >> finer;
        whole.k = next.k >> finer;
      }
      append_facing(whole, axis, side, found);
    }
}

/// The box, or the smallest of its parts on the side that faces back along the axis.
void PoseBoxes::append_facing(const PoseBox& box, int axis, int side, std::vector<PoseBox>& found) const
{
  if (!is_split(box))
  {
    found.push_back(box);
    return;
  }
  const int facing = side > 0 ? 0 : 1;
  for (int part = 0; part < 4; ++part)
  {
    const int a = part & 1, b = part >> 1;
    const int di = axis == 0 ? facing : a, dj = axis == 1 ? facing : axis == 0 ? a : b, dk = axis == 2 ? facing : b;
    append_facing({box.level + 1, 2 * box.i + di, 2 * box.j + dj, 2 * box.k + dk}, axis, side, found);
  }
}

}  // namespace fourwis
