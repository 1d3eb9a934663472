#include "parallel_angle.h"

#include <algorithm>
#include <cmath>

namespace fourwis
{
namespace
{

/// Angles of all pieces so far [rad].
struct Range
{
  double low, high;

  Range with(double phi) const { return {std::min(low, phi), std::max(high, phi)}; }
};

/// Whether a wheel can follow angles throughout the range at an offset of k pi.
bool is_within_travel(const Range& range, double max_angle)
{
  const double lowest = range.low + std::ceil((-max_angle - range.low) / M_PI) * M_PI;
  return lowest + (range.high - range.low) <= max_angle;
}

/// Adds `turns` half turns to the angle of a piece without changing its motion.
void turn(PathPiece& piece, double turns)
{
  piece.phi += turns * M_PI;
  if (std::remainder(turns, 2.0) != 0.0) piece.length = -piece.length;
}

/// If two angles are equally near, the smaller turn is chosen. This much is rounding.
constexpr double kRounding = 1e-9;

/// How many half turns bring phi nearest to the angle before it, or next to nearest if only that is within the travel.
double half_turns(double before, double phi, const Range& range, double max_angle)
{
  const double exact = (before - phi) / M_PI, nearest = std::round(exact * (1.0 - kRounding));
  const double second = nearest + (exact < nearest ? -1.0 : 1.0);
  const auto is_possible = [&](double turns) { return is_within_travel(range.with(phi + turns * M_PI), max_angle); };
  return is_possible(nearest) || !is_possible(second) ? nearest : second;
}

}  // namespace

void keep_angle_near(std::vector<PathPiece>& pieces, double max_angle)
{
  if (pieces.empty()) return;
  Range range{pieces.front().phi, pieces.front().phi};
  for (std::size_t i = 1; i < pieces.size(); ++i)
  {
    PathPiece& piece = pieces[i];
    turn(piece, half_turns(pieces[i - 1].phi, piece.phi, range, max_angle));
    range = range.with(piece.phi);
  }
  // Half turns bring the whole range as near to the middle of the travel as possible.
  const double turns = -std::round((range.low + range.high) / (2.0 * M_PI));
  for (PathPiece& piece : pieces) turn(piece, turns);
}

}  // namespace fourwis
