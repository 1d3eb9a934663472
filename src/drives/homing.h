#pragma once

#include <cstdint>
#include <optional>

#include "drive_objects.h"

namespace fourwis::drives
{

/// Homing mode with methods that do not move: 35 and 37, and 34 with the index pulse at the motor's present position.
/// The present position becomes the home offset 607C.
class Homing
{
public:
  explicit Homing(const ObjectDictionary& dictionary) : dictionary_(dictionary) {}

  /// A rising bit 4 starts it. Returns the new value of the motor's present position [count]; nothing if homing does
  /// not start or the method is unknown.
  std::optional<double> command(std::uint16_t controlword, std::uint16_t previous)
  {
    if ((controlword & ~previous & 0x10) == 0) return std::nullopt;
    attained_ = dictionary_.get(object::kHomingMethod) != 0;
    failed_ = !attained_;
    if (failed_) return std::nullopt;
    return static_cast<double>(dictionary_.get(object::kHomeOffset));
  }

  /// Bits 10, 12 and 13 of the statusword.
  std::uint16_t status() const
  {
    const std::uint16_t target_reached = 1 << 10, attained = 1 << 12, error = 1 << 13;
    return attained_ ? target_reached | attained : failed_ ? error : 0;
  }

private:
  const ObjectDictionary& dictionary_;
  bool attained_ = false, failed_ = false;
};

}  // namespace fourwis::drives
