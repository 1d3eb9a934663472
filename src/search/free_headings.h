#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "disc_places.h"
#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/search/goal_distance.h"

namespace fourwis
{

/// Headings modulo pi in one word, one bit each: the two-disc model is the same after half a turn.
inline constexpr int kHeadings = 32;
using HeadingSet = std::uint32_t;
inline constexpr HeadingSet kAllHeadings = ~HeadingSet{0};
inline constexpr double kBin = M_PI / kHeadings;  ///< [rad]

inline int heading_bin(double theta)
{
  const double half_turns = theta / M_PI;
  return static_cast<int>((half_turns - std::floor(half_turns)) * kHeadings) % kHeadings;
}

/// Headings of a whole turn, the second half of which are those of the first seen from behind.
using WholeTurnSet = std::uint64_t;

inline WholeTurnSet from_both_sides(HeadingSet set)
{
  return WholeTurnSet{set} << kHeadings | set;
}

inline int whole_turn_bin(double theta)
{
  const double turns = theta / (2.0 * M_PI);
  return static_cast<int>((turns - std::floor(turns)) * 2 * kHeadings) % (2 * kHeadings);
}

/// The headings next to those of a set.
template <typename Set>
Set turned_by_one_bin(Set set)
{
  constexpr int last = std::numeric_limits<Set>::digits - 1;
  return set << 1 | set >> last | set >> 1 | set << last;
}

/// Which headings may be free in each cell; computed when first asked for. A motion that was found free has no pose in
/// the cell at the other headings. It passes from one cell or heading to the next through a pose that belongs to both.
class FreeHeadings
{
public:
  /// Uses the clearance of the disc centres at the centre of a cell and, if given, the places where they may be.
  FreeHeadings(const CollisionChecker& checker, const CoarseCells& cells, const DiscPlaces* places = nullptr)
    : checker_(checker),
      cells_(cells),
      places_(places),
      known_(cells.count(), 0),
      free_(cells.count(), 0)
  {
    const double clearance = checker.least_clearance();
    for (std::size_t k = 0; k < kHeadings; ++k)
    {
      ring_[k] = around((static_cast<double>(k) + 0.5) * kBin);
      radii_[k] = clearance - std::hypot(ring_[k].reach_x, ring_[k].reach_y);
    }
    open_radius_ = checker.discs().offset + (places ? clearance : *std::max_element(radii_.begin(), radii_.end()));
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
  /// Where a disc centre is while C, the centre of the wheels, is in a cell and the heading in a bin.
  struct Spot
  {
    double x, y;              ///< at the centres of both, relative to C [m]
    double reach_x, reach_y;  ///< and how far from there it may be along the map's axes [m]
  };

  Spot around(double heading) const
  {
    const double offset = checker_.discs().offset, half = cells_.size() / 2.0;
    const double on_map = heading - checker_.map().origin().theta;
    const double c = std::abs(std::cos(on_map)), s = std::abs(std::sin(on_map));
    const double across = offset * std::sin(kBin / 2.0), along = offset * (1.0 - std::cos(kBin / 2.0));
    return {offset * std::cos(heading), offset * std::sin(heading), half + s * across + c * along,
            half + c * across + s * along};
  }

  HeadingSet compute(const Pose& centre) const
  {
    if (checker_.map().is_clear(centre.x, centre.y, open_radius_)) return kAllHeadings;
    HeadingSet free = 0;
    for (std::size_t k = 0; k < kHeadings; ++k)
      if (may_hold_disc(centre.x + ring_[k].x, centre.y + ring_[k].y, k) &&
          may_hold_disc(centre.x - ring_[k].x, centre.y - ring_[k].y, k))
        free |= HeadingSet{1} << k;
    return free;
  }

  /// Whether a disc centre that is here at the centre of cell and bin may be clear somewhere in them.
  bool may_hold_disc(double x, double y, std::size_t heading) const
  {
    const Spot& spot = ring_[heading];
    return checker_.map().is_clear(x, y, radii_[heading]) &&
           (!places_ || places_->any_near(x, y, spot.reach_x, spot.reach_y));
  }

  const CollisionChecker& checker_;
  const CoarseCells& cells_;
  const DiscPlaces* places_;
  std::array<Spot, kHeadings> ring_;     ///< of the front disc; the rear one is opposite
  std::array<double, kHeadings> radii_;  ///< clearance of the spots if a disc is clear anywhere around them [m]
  double open_radius_;                   ///< clearance of C with which all headings are free [m]
  std::vector<std::uint8_t> known_;
  std::vector<HeadingSet> free_;
};

}  // namespace fourwis
