#pragma once

#include <ostream>

#include "page.h"
#include "picture.h"

namespace fourwis
{

/// Colours of what is not a mode, used by the drawing and its legend.
inline constexpr const char* kFreeColour = "#ffffff";
inline constexpr const char* kOccupiedColour = "#2b303a";
inline constexpr const char* kUnknownColour = "#c9ced6";
inline constexpr const char* kCorridorColour = "#00a3b4";
inline constexpr const char* kIterationColour = "#7b3fb3";
inline constexpr const char* kStartColour = "#111111";
inline constexpr const char* kGoalColour = "#c2185b";

/// The strip below the map: what became of the plan, what the colours mean, a scale bar.
void write_legend(std::ostream& out, const Page& page, const PlanPicture& picture);

}  // namespace fourwis
