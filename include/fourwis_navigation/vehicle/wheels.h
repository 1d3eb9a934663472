#pragma once

#include <array>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Steering angles of the four wheels [rad] in wheel order, each modulo pi: (angle + pi, -speed) is the same motion.
using WheelAngles = std::array<double, kWheels>;

/// Angles of the wheels in a mode at equivalent steering angle phi, for v > 0, in (-pi, pi]. atan2 of the velocity of each
/// steering axis.
WheelAngles wheel_angles(const Robot& robot, Mode mode, double phi);

/// Speed of the fastest wheel for each m/s of C, the centre of the wheels.
double wheel_speed_ratio(const Robot& robot, Mode mode, double phi);

/// Least time in which all wheels can turn at rest from the one to the other, each by the shortest way within
/// `robot.wheel_max_angle` that gives the same motion, at `robot.wheel_max_rate` [s].
double reorientation_time(const Robot& robot, const WheelAngles& from, const WheelAngles& to);

}  // namespace fourwis
