#pragma once

#include <cstdint>
#include <memory>

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/sim/simulator_options.h"

namespace fourwis
{

/// A 4WIS base without mass: eight actuators, and a body that moves as its wheels roll. Repeatable: the same seed and the same
/// calls give the same motion, bit for bit.
class BaseSimulator
{
public:
  /// Throws std::invalid_argument naming the option, its value and the range.
  BaseSimulator(const Robot& robot, const SimulatorOptions& options);
  ~BaseSimulator();

  /// Puts the robot there, at rest; wheels keep their angles.
  void place(const Pose& pose);

  /// Takes effect `command_latency` later.
  void command(const WheelCommand& command);

  /// Lets time pass [s].
  void step(double duration);

  double time() const;      ///< since the beginning [s]
  Pose pose() const;        ///< where the body really is; theta is not wrapped
  WheelMotion truth() const;  ///< what the wheels really do
  WheelState wheels() const;  ///< as the encoders have it, stamped with time()

  void inject(const WheelFault& fault);
  void clear_faults();

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fourwis
