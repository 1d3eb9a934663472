#pragma once

#include <cmath>

#include "../support/random.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{

/// Appends a piece that begins where the path ends.
inline void append(Path& path, const Robot& robot, Mode mode, double phi, double length)
{
  path.pieces.push_back({mode, path.goal, phi, length});
  path.goal = advance(robot, path.goal, mode, phi, length);
}

/// A path from `start` without pieces yet.
inline Path path_from(const Pose& start)
{
  Path path;
  path.goal = start;
  return path;
}

/// Pieces of all modes, either direction, 1 cm to 3 m long, several of one mode in a row.
inline Path random_path(const Robot& robot, Random& random)
{
  Path path = path_from(random.pose(10.0));
  const int count = random.whole(1, 12);
  Mode mode = random.mode();
  for (int i = 0; i < count; ++i)
  {
    if (random.chance(0.3)) mode = random.mode();
    const double length = 0.01 * std::pow(300.0, random.between(0.0, 1.0));
    append(path, robot, mode, random.steering(robot, mode), random.chance(0.3) ? -length : length);
  }
  return path;
}

}  // namespace fourwis
