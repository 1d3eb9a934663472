#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

namespace fourwis
{

/// Motion mode of a 4WIS base; the numbers are those of the messages. What a mode does is in vehicle/mode_traits.h.
enum class Mode : std::uint8_t
{
  none = 0,
  ackermann = 1,  ///< drives like a car, ICR on the body's y axis
  lateral = 2,    ///< drives like a car turned by 90 degrees, ICR on the body's x axis
  parallel = 3,   ///< all wheels at one angle, translates without turning
  spin = 4        ///< turns in place; not planned yet
};

struct ModeName
{
  Mode mode;
  const char* name;
};

/// All modes, by their numbers.
inline constexpr ModeName kModes[] = {
    {Mode::none, "none"},         {Mode::ackermann, "ackermann"}, {Mode::lateral, "lateral"},
    {Mode::parallel, "parallel"}, {Mode::spin, "spin"},
};
inline constexpr std::size_t kModeCount = std::size(kModes);

/// The modes the planner plans in, in the order in which ties are broken.
inline constexpr std::array kPlannedModes = {Mode::ackermann, Mode::lateral, Mode::parallel};

/// How a car drives.
inline constexpr Mode kCarMode = Mode::ackermann;

/// False for numbers that no mode has. Messages may hold such.
constexpr bool is_mode(Mode mode)
{
  return static_cast<std::size_t>(mode) < kModeCount;
}

/// The place of a mode in tables of all modes. What is no mode counts as Mode::none.
constexpr std::size_t index_of(Mode mode)
{
  return is_mode(mode) ? static_cast<std::size_t>(mode) : 0;
}

/// A value for each mode.
template <class Value>
class PerMode
{
public:
  Value& operator[](Mode mode) { return values_[index_of(mode)]; }
  const Value& operator[](Mode mode) const { return values_[index_of(mode)]; }

private:
  std::array<Value, kModeCount> values_{};
};

/// Whether a table whose rows have a `mode` has those of all modes, in the order of their numbers.
template <class Row, std::size_t count>
constexpr bool has_a_row_for_each_mode(const Row (&rows)[count])
{
  for (std::size_t i = 0; i < count; ++i)
    if (static_cast<std::size_t>(rows[i].mode) != i) return false;
  return count == kModeCount;
}
static_assert(has_a_row_for_each_mode(kModes));

constexpr bool is_planned(Mode mode)
{
  for (Mode planned : kPlannedModes)
    if (mode == planned) return true;
  return false;
}

constexpr const char* to_string(Mode mode)
{
  return kModes[index_of(mode)].name;
}

/// The planned mode of that name, or nothing.
inline std::optional<Mode> mode_from_string(const std::string& name)
{
  for (Mode mode : kPlannedModes)
    if (name == to_string(mode)) return mode;
  return std::nullopt;
}

/// A set of planned modes: of all of them unless told otherwise. Inserting any other mode changes nothing.
class ModeSet
{
public:
  constexpr ModeSet() : ModeSet(none())
  {
    for (Mode mode : kPlannedModes) insert(mode);
  }
  constexpr ModeSet(std::initializer_list<Mode> modes)
  {
    for (Mode mode : modes) insert(mode);
  }
  static constexpr ModeSet none() { return ModeSet(std::initializer_list<Mode>{}); }

  constexpr bool contains(Mode mode) const { return is_mode(mode) && (bits_ & bit(mode)) != 0; }
  constexpr void insert(Mode mode)
  {
    if (is_planned(mode)) bits_ |= bit(mode);
  }
  constexpr bool empty() const { return bits_ == 0; }

  /// The first of them in the order of kPlannedModes, or Mode::none: a robot at rest with wheels anywhere starts in it.
  constexpr Mode first() const
  {
    for (Mode mode : kPlannedModes)
      if (contains(mode)) return mode;
    return Mode::none;
  }

  /// The modes in both sets.
  friend constexpr ModeSet operator&(const ModeSet& a, const ModeSet& b)
  {
    ModeSet both = none();
    both.bits_ = a.bits_ & b.bits_;
    return both;
  }
  friend constexpr bool operator==(const ModeSet& a, const ModeSet& b) { return a.bits_ == b.bits_; }
  friend constexpr bool operator!=(const ModeSet& a, const ModeSet& b) { return !(a == b); }

private:
  static constexpr std::uint32_t bit(Mode mode) { return std::uint32_t{1} << static_cast<unsigned>(mode); }

  std::uint32_t bits_ = 0;
};

/// The names of the planned modes, `separator` between them, `last` before the last one.
inline std::string planned_mode_names(const std::string& separator, const std::string& last)
{
  std::string names;
  for (std::size_t k = 0; k < kPlannedModes.size(); ++k)
    names += (k == 0 ? "" : k + 1 < kPlannedModes.size() ? separator : last) + to_string(kPlannedModes[k]);
  return names;
}

}  // namespace fourwis
