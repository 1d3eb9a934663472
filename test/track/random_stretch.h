#pragma once

#include <algorithm>

#include "../support/random.h"
#include "fourwis_navigation/model/trajectory.h"
#include "track/roll_out.h"

namespace fourwis
{

/// A random stretch of one mode from rest to rest within the limits. v and phi are linear between points with this
/// spacing in time.
inline Trajectory random_stretch(Random& random, const Robot& robot, Mode mode, double spacing = 0.2,
                                 int intervals = 12)
{
  const double greatest_phi = mode == Mode::parallel ? 1.2 : 0.8 * robot.max_steering_angle;
  const double most = 0.8 * robot.max_acceleration * spacing;
  MotionState state = {random.pose(5.0), 0.0, random.between(-greatest_phi, greatest_phi)};
  Trajectory points = {{0.0, mode, state.pose.x, state.pose.y, state.pose.theta, 0.0, state.phi}};
  for (int k = 1; k <= intervals; ++k)
  {
    const double stoppable = std::min(robot.max_speed, (intervals - k) * most);
    const double v = std::clamp(state.v + random.between(-most, most), -stoppable, stoppable);
    const double phi = std::clamp(state.phi + random.between(-spacing, spacing), -greatest_phi, greatest_phi);
    const MotionInput input = {(v - state.v) / spacing, (phi - state.phi) / spacing};
    for (int part = 0; part < 8; ++part) state = roll_out(robot, mode, state, input, spacing / 8);
    state.v = v;
    points.push_back({k * spacing, mode, state.pose.x, state.pose.y, state.pose.theta, state.v, state.phi});
  }
  return points;
}

}  // namespace fourwis
