#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "../protocol/frame_bytes.h"
#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{

/// A simulated base with the Ranger protocol, in raw bytes. It takes half a second to change its mode, its wheels reach
/// their targets at once, and it stops 500 ms after the last command. It has its own geometry of the modes, with
/// L = 0.68 m and W = 0.52 m.
class FakeRanger
{
public:
  explicit FakeRanger(Bus& end) : end_(end) {}

  /// Advances the time by a millisecond.
  void step()
  {
    ++ms_;
    for (Frame frame; end_.receive(frame) == BusStatus::ok;) obey(frame);
    if (ms_ - commanded_ > 500) speed = yaw = lateral = 0;
    if (silent) return;
    if (ms_ % 100 == 0 && tells_state)
      end_.send(frame_of(0x211, {vehicle, in_control ? 1 : 3, 0x01, 0xE0, 0, errors, 0, 0}));
    if (ms_ % 20 == 0) report();
  }

  bool changing() const { return ms_ - mode_changed_ < 500; }

  int mode = 0, vehicle = 0, errors = 0;
  bool in_control = false, silent = false;
  bool jammed = false, blocked = false;  ///< its wheels do not turn, do not roll
  bool tells_mode = true, tells_state = true;
  int motions = 0;                                    ///< commands of motion so far
  int speed = 0, yaw = 0, lateral = 0, steering = 0;  ///< as commanded last [0.001]

private:
  static int number(const Frame& frame, std::size_t at)
  {
    return static_cast<std::int16_t>(frame.data[at] << 8 | frame.data[at + 1]);
  }

  void obey(const Frame& frame)
  {
    if (frame.id == 0x421) in_control = frame.data[0] == 1;
    if (frame.id == 0x441) vehicle = errors = 0;
    if (frame.id == 0x141 && frame.data[0] != mode)
    {
      mode = frame.data[0];
      mode_changed_ = ms_;
    }
    if (frame.id != 0x111) return;
    commanded_ = ms_;
    ++motions;
    speed = number(frame, 0);
    yaw = number(frame, 2);
    lateral = number(frame, 4);
    if (!jammed) steering = number(frame, 6);
  }

  void report()
  {
    const auto [angle, v] = wheels();
    end_.send(words(0x271, angle));
    end_.send(words(0x281, blocked ? std::array<int, 4>{} : v));
    if (tells_mode) end_.send(frame_of(0x291, {mode, changing() ? 1 : 0, 0, 0, 0, 0, 0, 0}));
  }

  struct Wheels
  {
    std::array<int, 4> angle, speed;
  };
  /// Front-left, front-right, rear-left, rear-right.
  Wheels wheels() const
  {
    const int quarter = 1571, spin = static_cast<int>(std::lround(1000.0 * std::atan2(0.68, -0.52)));
    switch (mode)
    {
      case 0:
      {
        const double inner = steering / 1000.0;
        if (steering == 0) return {{0, 0, 0, 0}, {speed, speed, speed, speed}};
        const double x = 0.34, y = x / std::tan(std::abs(inner)) + 0.26;  // of the turning centre
        const int outer = static_cast<int>(std::lround(1000.0 * std::atan(x / (y + 0.26))));
        const int in = std::abs(steering);
        if (steering > 0) return {{in, outer, -in, -outer}, {speed, speed, speed, speed}};
        return {{-outer, -in, outer, in}, {speed, speed, speed, speed}};
      }
      case 1: return {{steering, steering, steering, steering}, {speed, speed, speed, speed}};
      case 2:
      {
        const int v = static_cast<int>(std::lround(yaw * std::hypot(0.68, 0.52) / 2.0));
        return {{spin - 3142, 3142 - spin, 3142 - spin, spin - 3142}, {-v, v, -v, v}};
      }
      case 4: return {{quarter, quarter, quarter, quarter}, {lateral, lateral, lateral, lateral}};
      default: return {{0, 0, 0, 0}, {0, 0, 0, 0}};
    }
  }

  static Frame words(std::uint32_t id, const std::array<int, 4>& values)
  {
    Frame frame;
    frame.id = id;
    for (const int value : values)
    {
      frame.data[frame.size++] = static_cast<std::uint8_t>(value >> 8);
      frame.data[frame.size++] = static_cast<std::uint8_t>(value);
    }
    return frame;
  }

  Bus& end_;
  long ms_ = 0, commanded_ = 0, mode_changed_ = -1000;
};

}  // namespace fourwis::can
