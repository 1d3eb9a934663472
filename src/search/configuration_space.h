#pragma once

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/interrupt.h"
#include "heading_slices.h"

namespace fourwis
{

/// At which headings the checker's body is free at each point of a lattice, with as much margin as the checker asks for there.
/// If interrupted it stops early, and the result is not usable.
HeadingSlices free_headings(const CollisionChecker& checker, double spacing, const Interrupt& interrupt);

}  // namespace fourwis
