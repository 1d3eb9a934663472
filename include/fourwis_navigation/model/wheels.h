#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// One number for each wheel, in wheel order: front-left, front-right, rear-left, rear-right.
using PerWheel = std::array<double, kWheels>;

/// The greatest magnitude of the four.
inline double greatest_magnitude(const PerWheel& values)
{
  double greatest = 0.0;
  for (double value : values) greatest = std::max(greatest, std::abs(value));
  return greatest;
}

/// The greatest difference between two wheels' numbers; of angles a full turn is one.
inline double greatest_gap(const PerWheel& a, const PerWheel& b)
{
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, std::abs(a[i] - b[i]));
  return greatest;
}

/// Angle and rolling speed of the four wheels. (angle + pi, -speed) is the same motion of the body.
struct WheelMotion
{
  PerWheel angle{};  ///< steering angle, 0: along x, counter-clockwise, not wrapped: within the wheel's travel [rad]
  PerWheel speed{};  ///< rolling speed along the wheel's heading [m/s]
};

/// What a base is told to do with its wheels.
struct WheelCommand
{
  Mode mode = Mode::none;  ///< the mode the wheels are set for; `none`: stop and hold the angles, the rest is ignored
  std::uint32_t sequence = 0;  ///< grows from command to command; wraps around
  WheelMotion motion;
};

/// What a base is able to do at the moment.
enum class BaseState : std::uint8_t
{
  not_ready = 0,  ///< starting, or without a connection to its drives
  ready = 1,      ///< could move, but the drives are not enabled, or are just being enabled
  enabled = 2,    ///< follows commands
  stopping = 3,   ///< comes to rest by itself; commands are ignored
  fault = 4       ///< at rest or coasting; a person has to clear it
};

/// What a base says of its wheels.
struct WheelState
{
  double stamp = 0.0;  ///< when it was measured [s]
  BaseState state = BaseState::not_ready;
  Mode mode = Mode::none;      ///< of the last command that was taken; `none` once the base has stopped by itself
  std::uint32_t sequence = 0;  ///< likewise
  WheelMotion motion;          ///< as measured
  bool aligned = false;        ///< every wheel has stayed near the last command's angle long enough to drive
};

}  // namespace fourwis
