#pragma once

#include <array>

#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// A stretch of a Reeds-Shepp curve, in units of the turning radius.
struct ReedsSheppSegment
{
  int turn = 0;         ///< +1 left, -1 right, 0 straight
  double length = 0.0;  ///< signed: negative drives backward
};

/// One word, for example L+ R- S- L-; at most five segments. Segments of no length are left out.
struct ReedsSheppPath
{
  std::array<ReedsSheppSegment, 5> segments{};
  std::size_t count = 0;  ///< segments in use
  double length = 0.0;    ///< sum of absolute lengths, in turning radii
};

/// All words (at most 48) that lead from the origin to a pose.
struct ReedsSheppWords
{
  std::array<ReedsSheppPath, 48> paths;
  std::size_t count = 0;
};

/// Every Reeds-Shepp word from (0, 0, 0) to `goal`, whose x and y are in turning radii. Formulas (8.1) to (8.11) of
/// Reeds and Shepp, "Optimal paths for a car that goes both forwards and backwards", 1990, with their misprints
/// corrected. Arcs are at most half a turn. Each word ends within 1e-12 (1 + distance) of the goal. These three
/// functions do not allocate, and throw std::invalid_argument if the goal is not finite.
void reeds_shepp_words(const Pose& goal, ReedsSheppWords& words);

/// Length of the shortest word [turning radii].
double reeds_shepp_length(const Pose& goal);

/// The shortest word.
ReedsSheppPath shortest_reeds_shepp(const Pose& goal);

}  // namespace fourwis
