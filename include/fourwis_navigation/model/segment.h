#pragma once

#include <cstddef>
#include <vector>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// The reference of one stretch of a path between two switches, resampled: N intervals between N + 1 knots. Every cusp
/// (change of driving direction) is a knot. Headings are continuous, not wrapped.
struct Segment
{
  Mode mode = Mode::none;
  std::vector<Pose> knots;  ///< N + 1 poses, map frame
  std::vector<double> phi;  ///< N, equivalent steering angle on each interval [rad]
  std::vector<double>
      length;  ///< N, signed arc length of the centre of the wheels on each interval [m]; negative: backward

  std::size_t intervals() const { return phi.size(); }
};

}  // namespace fourwis
