#pragma once

#include <array>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// A short motion from rest to rest: accelerate, creep, brake.
using Creep = std::array<TrajectoryPoint, 4>;

/// Turns in place by `angle` [rad], wheels rolling at up to `speed` [m/s].
Creep creeping_turn(const Robot& robot, const Pose& from, double angle, double speed);

/// Straight to the place of `to` without turning, all wheels parallel, at up to `speed` [m/s].
Creep creeping_shift(const Pose& from, const Pose& to, double speed);

}  // namespace fourwis
