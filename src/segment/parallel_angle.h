#pragma once

#include <vector>

#include "fourwis_navigation/model/path.h"

namespace fourwis
{

/// Replaces (phi, length) of each parallel piece by the same motion (phi +- k pi, +- length) whose angle is nearest to
/// that of the piece before it, among those that a wheel with a travel of +- `max_angle` [rad] can take without a jump
/// by pi since the first piece. If there is none, the nearest angle is taken. All angles lie around the middle of the
/// travel.
void keep_angle_near(std::vector<PathPiece>& pieces, double max_angle);

}  // namespace fourwis
