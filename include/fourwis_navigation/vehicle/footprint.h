#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "fourwis_navigation/model/point.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Two discs that stand for the body, one behind the other: centres at `middle` +- (offset, 0) in the frame of C.
struct TwoDiscs
{
  double offset;  ///< half the distance of the centres [m]
  double radius;  ///< that the centres keep from obstacles [m]
  Point2 middle = {0.0, 0.0};

  /// Distance of the farther centre from C, the centre of the wheels [m].
  double reach() const { return std::hypot(std::abs(middle.x) + offset, middle.y); }
};

/// The two discs that cover the rectangle that the body fills, paper eq. (8) and (9): offset l/4, radius r_c = r_b + r_safe.
TwoDiscs two_discs(const Robot& robot);

/// Two discs within the body, as wide as the body and as far apart as possible. If the body keeps `margin` [m] from all
/// obstacles, the disc centres keep `radius`.
TwoDiscs inscribed_discs(const Robot& robot, double margin);

/// Equal discs that cover the body.
struct DiscCover
{
  std::vector<Point2> centres;  ///< in the frame of C, from front to rear [m]
  double radius;                ///< that the centres keep from obstacles [m]

  /// Distance of the farthest disc centre from C, the centre of the wheels [m].
  double reach() const
  {
    double farthest = 0.0;
    for (const Point2& centre : centres) farthest = std::max(farthest, std::hypot(centre.x, centre.y));
    return farthest;
  }
};

/// Discs over the cells of a grid on the body: strips across it, `along` of them, each of them cut `across` times as wide as the
/// body is there. The radius includes the safety margin. The paper's discs are two along and one across. More discs in one row
/// extend less beyond the sides, but more beyond front and rear. Several rows extend less everywhere.
DiscCover disc_cover(const Robot& robot, int along, int across = 1);

/// The same discs, as small as they can be without uncovering the body.
inline DiscCover without_margin(DiscCover cover, const Robot& robot)
{
  cover.radius -= robot.safety_margin;
  return cover;
}

}  // namespace fourwis
