#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "drive_bench.h"
#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::drives
{

/// A master of eight drives in raw bytes: it sets them up and then sends a cycle every 10 ms. Steering drives 1 to 4
/// (cyclic positions), driving drives 5 to 8 (cyclic velocities).
class RawMaster
{
public:
  explicit RawMaster(can::Bus& end) : end_(end) {}

  /// The requests that set up one node, in order.
  static std::vector<can::Frame> configuration(int node)
  {
    const int mode = node <= 4 ? 8 : 9;
    const int target_low = node <= 4 ? 0x7A : 0xFF;
    const std::uint32_t id = 0x600 + static_cast<std::uint32_t>(node);
    const auto sdo = [id](std::initializer_list<int> bytes) { return raw(id, bytes); };
    return {sdo({0x23, 0x00, 0x14, 1, node, 0x02, 0, 0x80}),
            sdo({0x2F, 0x00, 0x16, 0, 0, 0, 0, 0}),
            sdo({0x23, 0x00, 0x16, 1, 0x10, 0x00, 0x40, 0x60}),
            sdo({0x23, 0x00, 0x16, 2, 0x08, 0x00, 0x60, 0x60}),
            sdo({0x23, 0x00, 0x16, 3, 0x20, 0x00, target_low, 0x60}),
            sdo({0x2F, 0x00, 0x16, 0, 3, 0, 0, 0}),
            sdo({0x2F, 0x00, 0x14, 2, 1, 0, 0, 0}),
            sdo({0x23, 0x00, 0x14, 1, node, 0x02, 0, 0}),
            sdo({0x23, 0x00, 0x18, 1, 0x80 + node, 0x01, 0, 0x80}),
            sdo({0x2F, 0x00, 0x1A, 0, 0, 0, 0, 0}),
            sdo({0x23, 0x00, 0x1A, 1, 0x10, 0x00, 0x41, 0x60}),
            sdo({0x23, 0x00, 0x1A, 2, 0x08, 0x00, 0x61, 0x60}),
            sdo({0x2F, 0x00, 0x1A, 0, 2, 0, 0, 0}),
            sdo({0x2F, 0x00, 0x18, 2, 1, 0, 0, 0}),
            sdo({0x23, 0x00, 0x18, 1, 0x80 + node, 0x01, 0, 0}),
            sdo({0x2F, 0x01, 0x1A, 0, 0, 0, 0, 0}),
            sdo({0x23, 0x01, 0x1A, 1, 0x20, 0x00, 0x64, 0x60}),
            sdo({0x23, 0x01, 0x1A, 2, 0x20, 0x00, 0x6C, 0x60}),
            sdo({0x2F, 0x01, 0x1A, 0, 2, 0, 0, 0}),
            sdo({0x2F, 0x01, 0x18, 2, 1, 0, 0, 0}),
            sdo({0x23, 0x01, 0x18, 1, 0x80 + node, 0x02, 0, 0}),
            sdo({0x23, 0x16, 0x10, 1, 0x64, 0, 0x7F, 0}),
            sdo({0x2F, 0x29, 0x10, 1, 2, 0, 0, 0}),
            sdo({0x2B, 0x07, 0x60, 0, 3, 0, 0, 0}),
            sdo({0x2B, 0x17, 0x10, 0, 50, 0, 0, 0}),
            sdo({0x2F, 0xC2, 0x60, 1, 10, 0, 0, 0}),
            sdo({0x2F, 0x60, 0x60, 0, mode, 0, 0, 0})};
  }

  /// One cycle: heartbeat every fifth time, targets with this controlword, SYNC.
  void cycle(int controlword)
  {
    if (cycles_++ % 5 == 0) end_.send(raw(0x77F, {0x05}));
    for (int node = 1; node <= 8; ++node) end_.send(command(node, controlword));
    end_.send(raw(0x080, {}));
  }

  can::Bus& end() { return end_; }

  /// In counts and counts/s, node 1 first.
  std::array<double, 8> target{};

private:
  can::Frame command(int node, int controlword) const
  {
    const auto counts = static_cast<std::int32_t>(std::lround(target[static_cast<std::size_t>(node - 1)]));
    const auto byte = [&](int k) { return static_cast<int>(static_cast<std::uint32_t>(counts) >> 8 * k & 0xFF); };
    return raw(0x200 + static_cast<std::uint32_t>(node),
               {controlword & 0xFF, controlword >> 8, node <= 4 ? 8 : 9, byte(0), byte(1), byte(2), byte(3)});
  }

  can::Bus& end_;
  int cycles_ = 0;
};

}  // namespace fourwis::drives
