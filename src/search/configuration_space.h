#pragma once

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/interrupt.h"
#include "heading_slices.h"

namespace fourwis
{

/// At which headings the checker's body is free at each point of a lattice, with as much margin as the checker asks for there.
/// If interrupted it stops early, and the result is not usable.
HeadingSlices free_headings(const CollisionChecker& checker, double spacing, const Interrupt& interrupt);

/// The headings at which the body may be free anywhere around each point, up to half the spacing and half a bin away: at the
/// others no motion is that the checker found free.
HeadingSlices possibly_free_headings(const CollisionChecker& checker, double spacing, const Interrupt& interrupt);

}  // namespace fourwis
