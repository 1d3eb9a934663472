#pragma once

#include <cmath>
#include <vector>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// A stretch driven in one mode, in one direction, with the wheels held still.
struct PathPiece
{
  Mode mode = Mode::none;
  Pose start;        ///< where it begins, map frame
  double phi = 0.0;  ///< equivalent steering angle [rad]
  /// Signed arc length of C, the centre of the wheels [m]; negative drives backward (to the right in lateral mode).
  double length = 0.0;
};

/// The front end's answer. Pieces follow one another without gaps: each begins where the one before it ends, and a
/// switch of modes (at rest) lies between neighbours of different modes.
struct Path
{
  std::vector<PathPiece> pieces;
  Pose goal;                         ///< where the last piece ends
  double cost = 0.0;                 ///< accumulated cost g of the search, in metres of travel
  bool begins_with_way_out = false;  ///< the first piece is driven as it is, to its end at rest

  double length() const
  {
    double sum = 0.0;
    for (const PathPiece& piece : pieces) sum += std::abs(piece.length);
    return sum;
  }
  int switches() const
  {
    int count = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i) count += pieces[i].mode != pieces[i - 1].mode;
    return count;
  }
};

}  // namespace fourwis
