#pragma once

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include "../support/random.h"
#include "fourwis_navigation/model/pose.h"
#include "search/reeds_shepp.h"

namespace fourwis
{

inline std::ostream& operator<<(std::ostream& out, const Pose& pose)
{
  return out << "(" << pose.x << ", " << pose.y << ", " << pose.theta << ")";
}

/// Where a car with turning radius `radius` ends that drives `path` from `start`.
inline Pose drive(const ReedsSheppPath& path, Pose start = {}, double radius = 1.0)
{
  for (std::size_t i = 0; i < path.count; ++i)
  {
    const ReedsSheppSegment& segment = path.segments[i];
    const double angle = segment.turn * segment.length;
    const double chord = radius * (segment.turn == 0 ? segment.length : 2.0 * segment.turn * std::sin(angle / 2.0));
    start.x += chord * std::cos(start.theta + angle / 2.0);
    start.y += chord * std::sin(start.theta + angle / 2.0);
    start.theta += angle;
  }
  return start;
}

/// The greater of the errors in position and in heading.
inline double error(const Pose& a, const Pose& b)
{
  return std::max(distance(a, b), std::abs(wrap_angle(a.theta - b.theta)));
}

/// Poses of all headings within squares of 0.01 to 100 turning radii around the origin.
inline std::vector<Pose> random_poses(int count, unsigned seed)
{
  Random random(seed);
  const double sizes[] = {0.01, 0.5, 2.0, 5.0, 20.0, 100.0};
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i)
  {
    const double size = sizes[i % 6];
    const double heading = i % 12 == 0 ? size : M_PI;
    poses.push_back({size * random.unit(), size * random.unit(), heading * random.unit()});
  }
  return poses;
}

/// Words of up to five letters whose lengths are mostly those where one formula ends and another begins, and tiny ones.
inline std::vector<ReedsSheppPath> border_words(int count, unsigned seed)
{
  Random random(seed);
  const double borders[] = {0.0, M_PI / 2, M_PI, M_PI / 3, 2 * M_PI / 3, 1e-3, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14};
  std::vector<ReedsSheppPath> words(static_cast<std::size_t>(count));
  for (ReedsSheppPath& word : words)
  {
    word.count = static_cast<std::size_t>(random.whole(1, 5));
    for (std::size_t i = 0; i < word.count; ++i)
    {
      const int turn = random.whole(-1, 1);
      const double length = random.chance(1.0 / 3.0) ? random.between(0.0, M_PI) : borders[random.whole(0, 10)];
      word.segments[i] = {turn, random.chance(0.5) ? length : -length};
      word.length += length;
    }
  }
  return words;
}

}  // namespace fourwis
