#pragma once

#include <string>

#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Farthest that a wheel may have to turn at rest before the robot can drive in another mode [rad]. It starts anywhere
/// within its travel and takes the shortest way that choose_branches() leaves it. A stretch of parallel motion counts as
/// one at a fixed angle.
double farthest_turn(const Robot& robot);

/// Throws std::invalid_argument, naming `key` and `wheel_max_rate`, where a timeout [s] is too short for the farthest
/// turn and what else passes meanwhile: `besides` [s].
void check_alignment_timeout(const Robot& robot, const std::string& key, double timeout, double besides);

}  // namespace fourwis
