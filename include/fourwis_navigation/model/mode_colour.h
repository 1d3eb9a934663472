#pragma once

#include <cstdint>

#include "fourwis_navigation/model/mode.h"

namespace fourwis
{

/// Parts of 255.
struct Colour
{
  std::uint8_t red, green, blue;
};

struct ModeColour
{
  Mode mode;
  Colour colour;
};

/// What each mode is drawn in, in pictures and in rviz.
inline constexpr ModeColour kModeColours[] = {
    {Mode::none, {0x7a, 0x7f, 0x87}},       // grey
    {Mode::ackermann, {0x1f, 0x6f, 0xd1}},  // blue
    {Mode::lateral, {0xf0, 0x8a, 0x1d}},    // orange
    {Mode::parallel, {0x2a, 0x9d, 0x4a}},   // green
    {Mode::spin, {0x8a, 0x5a, 0x2b}},       // brown
};
static_assert(has_a_row_for_each_mode(kModeColours));

constexpr const Colour& colour_of(Mode mode)
{
  return kModeColours[index_of(mode)].colour;
}

}  // namespace fourwis
