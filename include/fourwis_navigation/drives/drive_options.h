#pragma once

#include <cstdint>

namespace fourwis::drives
{

/// The delivery state of a drive.
struct DriveOptions
{
  std::uint8_t node = 1;               ///< node id, 1 to 127
  std::uint32_t vendor = 0x4F57;       ///< 1018:1
  std::uint32_t product = 0x0402;      ///< 1018:2
  std::uint32_t serial = 1;            ///< 1018:4
  double boot_time = 0.1;              ///< from power-on or reset to the boot-up message [s]
  double self_test_time = 0.02;        ///< from there to `switch on disabled` [s]
  double max_velocity = 1e6;           ///< greatest velocity that is demanded of the motor [count/s]
  double profile_velocity = 1e5;       ///< 6081 [count/s]
  double acceleration = 1e6;           ///< 6083 and 6084 [count/s^2]
  double quick_stop = 1e6;             ///< 6085 [count/s^2]
  double following_window = 1e5;       ///< 6065: a position further away than this is a following error [count]
  std::uint16_t following_time = 100;  ///< 6066: a following error of this duration is a fault [ms]
};

}  // namespace fourwis::drives
