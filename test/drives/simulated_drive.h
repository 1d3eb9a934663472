#pragma once

#include <cmath>
#include <cstdint>

#include "fourwis_navigation/sim/base_simulator.h"
#include "fourwis_navigation/vehicle/wheel_branches.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis
{

/// Gives a base commands every 20 ms to drive in a mode with v and phi, and advances its time.
class SimulatedDrive
{
public:
  static constexpr double kPeriod = 0.02;

  SimulatedDrive(const Robot& its_robot, const SimulatorOptions& options) : robot(its_robot), base(its_robot, options)
  {}

  /// The wheels of a mode on branches within their travel.
  WheelMotion wheels_for(Mode mode, double v, double phi) const
  {
    const PerWheel angle = choose_branches(robot, {mode, phi, phi, phi}, base.truth().angle).motion.angle;
    return continue_branches(robot, wheel_motion(robot, mode, v, phi), angle).motion;
  }

  void command(Mode mode, const WheelMotion& motion, double duration)
  {
    const auto periods = std::lround(duration / kPeriod);
    for (long k = 0; k < periods; ++k)
    {
      base.command({mode, ++sequence, motion});
      base.step(kPeriod);
    }
  }
  void drive(Mode mode, double v, double phi, double duration) { command(mode, wheels_for(mode, v, phi), duration); }

  /// Turns the wheels for a mode. True if the base reports that they are aligned for this command.
  bool align(Mode mode, double phi)
  {
    const WheelMotion motion = wheels_for(mode, 0.0, phi);
    const std::uint32_t before = sequence;
    for (int k = 0; k < 200; ++k)
    {
      command(mode, motion, kPeriod);
      const WheelState wheels = base.wheels();
      if (wheels.aligned && wheels.mode == mode && wheels.sequence > before) return true;
    }
    return false;
  }

  const Robot robot;
  BaseSimulator base;
  std::uint32_t sequence = 0;
};

}  // namespace fourwis
