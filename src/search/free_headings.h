#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/search/goal_distance.h"

namespace fourwis
{

/// Headings modulo pi in one word, one bit each: the two-disc model looks the same from behind.
inline constexpr int kHeadings = 32;
using HeadingSet = std::uint32_t;
inline constexpr HeadingSet kAllHeadings = ~HeadingSet{0};
inline constexpr double kBin = M_PI / kHeadings;   ///< [rad]

inline int heading_bin(double theta)
{
  const double half_turns = theta / M_PI;
  return static_cast<int>((half_turns - std::floor(half_turns)) * kHeadings) % kHeadings;
}

/// The headings next to those of a set.
inline HeadingSet turned_by_one_bin(HeadingSet set)
{
  return set << 1 | set >> (kHeadings - 1) | set >> 1 | set << (kHeadings - 1);
}

/// Which headings may be free in each cell; computed when first asked for.
class FreeHeadings
{
public:
  FreeHeadings(const CollisionChecker& checker, const CoarseCells& cells)
    : checker_(checker), cells_(cells), known_(cells.count(), 0), free_(cells.count(), 0)
  {
    const TwoDiscs& discs = checker.discs();
    // A pose of the cell differs from the one at its centre by half a diagonal and half a bin at most.
    radius_ = discs.radius - M_SQRT1_2 * cells.size() - discs.offset * kBin / 2.0;
    for (std::size_t k = 0; k < ring_.size(); ++k)
    {
      const double angle = (static_cast<double>(k) + 0.5) * kBin;
      ring_[k] = {discs.offset * std::cos(angle), discs.offset * std::sin(angle), 0.0};
    }
  }

  HeadingSet operator[](int cell)
  {
    const std::size_t c = static_cast<std::size_t>(cell);
    if (!known_[c])
    {
      free_[c] = compute(cells_.centre(cell));
      known_[c] = 1;
    }
    return free_[c];
  }

private:
  HeadingSet compute(const Pose& centre) const
  {
    const ObstacleMap& map = checker_.map();
    if (map.is_clear(centre.x, centre.y, radius_ + checker_.discs().offset)) return kAllHeadings;
    HeadingSet free = 0;
    for (std::size_t k = 0; k < kHeadings; ++k)
      if (map.is_clear(centre.x + ring_[k].x, centre.y + ring_[k].y, radius_) &&
          map.is_clear(centre.x - ring_[k].x, centre.y - ring_[k].y, radius_))
        free |= HeadingSet{1} << k;
    return free;
  }

  const CollisionChecker& checker_;
  const CoarseCells& cells_;
  double radius_;
  std::array<Pose, kHeadings> ring_;  ///< front disc centres at each heading, relative to C
  std::vector<std::uint8_t> known_;
  std::vector<HeadingSet> free_;
};

}  // namespace fourwis
