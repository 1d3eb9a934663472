#pragma once

#include <cmath>
#include <vector>

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

/// Equal discs that cover the body, with their centres on its x axis.
struct DiscCover
{
  std::vector<double> offsets;  ///< of the centres, from front to rear [m]
  double radius;                ///< safety margin included [m]
};

/// `count` discs, each over an equal part of the length. Two are the paper's; more of them stick out less.
inline DiscCover disc_cover(const Robot& robot, int count)
{
  const double part = robot.length / count;
  DiscCover cover{{}, std::hypot(part, robot.width) / 2.0 + robot.safety_margin};
  for (int i = 0; i < count; ++i) cover.offsets.push_back((robot.length - part) / 2.0 - i * part);
  return cover;
}

}  // namespace fourwis
