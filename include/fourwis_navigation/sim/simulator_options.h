#pragma once

#include <cstdint>

namespace fourwis
{

/// The simulated base; the keys of config/simulator.yaml.
struct SimulatorOptions
{
  std::uint32_t seed = 1;  ///< of all noise
};

/// What can go wrong with one wheel.
struct WheelFault
{
  enum class Kind
  {
    stuck_steering,  ///< the angle stays what it is
    dead_drive,      ///< the wheel does not drive, it rolls along
    frozen_encoders  ///< the wheel works, what is measured of it stays what it is
  };
  Kind kind = Kind::stuck_steering;
  int wheel = 0;  ///< in wheel order
};

}  // namespace fourwis
