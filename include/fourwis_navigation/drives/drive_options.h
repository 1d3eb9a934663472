#pragma once

#include <cstdint>

namespace fourwis::drives
{

/// The delivery state of a drive. Of a rate that is beyond the 32 bits of its object the drive keeps what they hold.
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

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("node", o.node, 1, 127);
    row("vendor", o.vendor, 0, 4294967295.0);
    row("product", o.product, 0, 4294967295.0);
    row("serial", o.serial, 0, 4294967295.0);
    row("boot_time", o.boot_time, 0.0, 600.0, "s");
    row("self_test_time", o.self_test_time, 0.0, 600.0, "s");
    row("max_velocity", o.max_velocity, 0.0, 1e15, "count/s");
    row("profile_velocity", o.profile_velocity, 0.0, 1e15, "count/s");
    row("acceleration", o.acceleration, 0.0, 1e15, "count/s^2");
    row("quick_stop", o.quick_stop, 0.0, 1e15, "count/s^2");
    row("following_window", o.following_window, 0.0, 1e15, "count");
    row("following_time", o.following_time, 0, 65535, "ms");
  }
};

/// Throws std::invalid_argument naming key, value and range.
void check(const DriveOptions& options);

}  // namespace fourwis::drives
