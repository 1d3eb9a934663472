#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "fourwis_navigation/model/point.h"
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

/// Two discs within the body, as far apart as possible and as wide as the body. If the body keeps `margin` [m] from all
/// obstacles, the disc centres keep `radius`.
inline TwoDiscs inscribed_discs(const Robot& robot, double margin)
{
  return {std::max(0.0, robot.length - robot.width) / 2.0, std::min(robot.length, robot.width) / 2.0 + margin};
}

/// Equal discs that cover the body.
struct DiscCover
{
  std::vector<Point2> centres;  ///< on the body, from front to rear [m]
  double radius;                ///< that the centres keep from obstacles [m]

  /// Distance of the farthest disc centre from C, the centre of the wheels [m].
  double reach() const { return centres.empty() ? 0.0 : std::hypot(centres.front().x, centres.front().y); }
};

/// Discs over the cells of a grid on the body, with the given numbers along and across it. The radius includes the
/// safety margin. The paper's discs are two along and one across. More discs in one row extend less beyond the sides,
/// but more beyond front and rear. Several rows extend less everywhere.
inline DiscCover disc_cover(const Robot& robot, int along, int across = 1)
{
  const double length = robot.length / along, width = robot.width / across;
  DiscCover cover{{}, std::hypot(length, width) / 2.0 + robot.safety_margin};
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j)
      cover.centres.push_back({(robot.length - length) / 2.0 - i * length, (robot.width - width) / 2.0 - j * width});
  return cover;
}

/// The same discs, as small as they can be without uncovering the body.
inline DiscCover without_margin(DiscCover cover, const Robot& robot)
{
  cover.radius -= robot.safety_margin;
  return cover;
}

}  // namespace fourwis
