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

/// A 4WIS base without mass: eight actuators and a body that moves as its wheels roll. By itself it stops when no
/// command comes, and it turns its wheels at standstill before it drives in another mode. Repeatable: the same seed and
/// the same calls give the same motion, bit for bit.
class BaseSimulator
{
public:
  /// Throws as check() does.
  BaseSimulator(const Robot& robot, const SimulatorOptions& options);

  /// Places the robot at a pose, at rest. The wheels keep their angles, pending commands are lost.
  void place(const Pose& pose);

  /// Gives a command, which takes effect `command_latency` later unless the base is stopping or at fault then. Returns
  /// false and ignores it if a number is not finite or the mode is not valid.
  bool command(const WheelCommand& command);

  /// Advances the time by `duration` [s], in whole time steps. The remainder is kept for the next call. Throws
  /// std::invalid_argument for a negative duration.
  void step(double duration);

  double time() const { return static_cast<double>(steps_) * options_.time_step; }  ///< since the beginning [s]
  const Pose& pose() const { return plant_.body().pose(); }     ///< where the body really is; theta is not wrapped
  const Twist& twist() const { return plant_.body().twist(); }  ///< how it really moves, in its own frame
  WheelMotion truth() const { return plant_.wheels(); }         ///< what the wheels really do
  WheelState wheels() const;                                    ///< as the encoders have it, stamped with time()

  /// Injects a fault; throws std::out_of_range for a wheel that does not exist.
  void inject(const WheelFault& fault);

  /// Removes all faults. A base at fault is enabled again and waits for a new command.
  void clear_faults();

private:
  struct Pending
  {
    std::int64_t due;  ///< the step in which it takes effect
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
  PerWheel speeds_{};  ///< the present targets of the drives [m/s]
  BaseState state_ = BaseState::enabled;
  std::int64_t steps_ = 0, taken_at_ = 0;
  double remainder_ = 0.0;
};

}  // namespace fourwis
