#pragma once

#include <cstdint>
#include <deque>

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/sim/encoders.h"
#include "fourwis_navigation/sim/interlock.h"
#include "fourwis_navigation/sim/plant.h"
#include "fourwis_navigation/sim/simulator_options.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{

/// A 4WIS base without mass: eight actuators, a body that moves as its wheels roll, and what a base does by itself: it
/// stops when nobody commands it, and turns its wheels at standstill before it drives in another mode. Repeatable: the
/// same seed and the same calls give the same motion, bit for bit.
class BaseSimulator
{
public:
  /// Throws std::invalid_argument naming the option, its value and the range.
  BaseSimulator(const Robot& robot, const SimulatorOptions& options);

  /// Puts the robot there, at rest; wheels keep their angles, commands on their way are lost.
  void place(const Pose& pose);

  /// Takes effect `command_latency` later, but not while the base is stopping or at fault. Returns false, and ignores
  /// it, when something in it is no number or its mode none of ours.
  bool command(const WheelCommand& command);

  /// Lets time pass [s], in whole time steps; what remains is kept for the next call. Throws std::invalid_argument for
  /// time that goes backward.
  void step(double duration);

  double time() const { return static_cast<double>(steps_) * options_.time_step; }  ///< since the beginning [s]
  const Pose& pose() const { return plant_.body().pose(); }     ///< where the body really is; theta is not wrapped
  const Twist& twist() const { return plant_.body().twist(); }  ///< how it really moves, in its own frame
  WheelMotion truth() const { return plant_.wheels(); }         ///< what the wheels really do
  WheelState wheels() const;                                    ///< as the encoders have it, stamped with time()

  /// Injects a fault; throws std::out_of_range for a wheel that does not exist.
  void inject(const WheelFault& fault);

  /// Repairs all wheels; a base at fault is enabled again and waits for a new command.
  void clear_faults();

private:
  struct Pending
  {
    std::int64_t due;  ///< the step it takes effect in
    WheelCommand command;
  };

  void step_once();
  void take_commands();
  void watch();
  void control();
  void stop();
  void set_speeds(const PerWheel& speeds);

  SimulatorOptions options_;
  double max_speed_;
  Plant plant_;
  Encoders encoders_;
  Interlock interlock_;
  std::deque<Pending> pending_;
  WheelCommand taken_;
  PerWheel speeds_{};  ///< what the drives are told at present [m/s]
  BaseState state_ = BaseState::enabled;
  std::int64_t steps_ = 0, taken_at_ = 0;
  double remainder_ = 0.0;
};

}  // namespace fourwis
