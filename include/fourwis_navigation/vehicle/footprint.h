#pragma once

#include <cmath>

#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// The two discs that cover the body, paper eq. (8) and (9): centres on the body's x axis at +- offset.
struct TwoDiscs
{
  double offset;  ///< l/4 [m]
  double radius;  ///< r_c = r_b + r_safe [m]
};

inline TwoDiscs two_discs(const Robot& robot)
{
  const double offset = robot.length / 4.0;
  return {offset, std::hypot(offset, robot.width / 2.0) + robot.safety_margin};
}

}  // namespace fourwis
