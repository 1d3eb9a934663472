#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace fourwis
{

/// Motion mode of a 4WIS base; the numbers are those of the messages (DESIGN.md section 3).
enum class Mode : std::uint8_t
{
  none = 0,
  ackermann = 1,  ///< drives like a car, ICR on the body's y axis
  lateral = 2,    ///< drives like a car turned by 90 degrees, ICR on the body's x axis
  parallel = 3,   ///< all wheels at one angle, translates without turning
  spin = 4        ///< turns in place; reserved, not planned yet
};

/// The modes the planner plans in, in the order in which ties are broken.
inline constexpr std::array<Mode, 3> kPlannedModes = {Mode::ackermann, Mode::lateral, Mode::parallel};

inline const char* to_string(Mode mode)
{
  switch (mode)
  {
    case Mode::none: return "none";
    case Mode::ackermann: return "ackermann";
    case Mode::lateral: return "lateral";
    case Mode::parallel: return "parallel";
    case Mode::spin: return "spin";
  }
  return "none";
}

/// The planned mode of that name, or nothing.
inline std::optional<Mode> mode_from_string(const std::string& name)
{
  for (Mode mode : kPlannedModes)
    if (name == to_string(mode)) return mode;
  return std::nullopt;
}

/// A set of planned modes.
struct ModeSet
{
  bool ackermann = true;
  bool lateral = true;
  bool parallel = true;

  bool contains(Mode mode) const
  {
    return (mode == Mode::ackermann && ackermann) || (mode == Mode::lateral && lateral) ||
           (mode == Mode::parallel && parallel);
  }
  void insert(Mode mode)
  {
    ackermann |= mode == Mode::ackermann;
    lateral |= mode == Mode::lateral;
    parallel |= mode == Mode::parallel;
  }
  bool empty() const { return !ackermann && !lateral && !parallel; }
  /// The first of them in the order of kPlannedModes; a robot at rest with wheels anywhere starts in it.
  Mode first() const
  {
    for (Mode mode : kPlannedModes)
      if (contains(mode)) return mode;
    return Mode::none;
  }
  static ModeSet none() { return {false, false, false}; }
};

}  // namespace fourwis
