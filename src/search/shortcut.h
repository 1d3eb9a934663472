#pragma once

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/model/path.h"
#include "mode_curves.h"

namespace fourwis
{

/// A path of at most the cost of `path`, from the same start to the same goal: dynamic programming over the places
/// where pieces meet, where any two may be joined by the cheapest free multi-modal curve instead. It corrects what a
/// weighted search has missed. Returns the best so far when interrupted.
Path shortcut(const CollisionChecker& checker, const ModeCurves& curves, const Path& path, const Interrupt& interrupt);

}  // namespace fourwis
