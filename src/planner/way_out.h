#pragma once

#include <optional>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{

/// The shortest motion that takes a body out of the obstacles that it overlaps at a pose, without ever going deeper; nothing
/// where there is none. Localisation is never exact: a robot beside a wall may be told that it stands in it.
std::optional<PathPiece> way_out(const World& world, const Pose& pose, const ModeSet& modes);

}  // namespace fourwis
