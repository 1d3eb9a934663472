#pragma once

#include <cmath>

#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// What the eight actuators can do; the limits of angle, rate and speed are the robot's.
struct ActuatorOptions
{
  double steering_lag = 0.02;        ///< time constant of a steering axis [s]
  double drive_lag = 0.03;           ///< time constant of a wheel's speed [s]
  double drive_acceleration = 12.0;  ///< greatest change of a wheel's rolling speed [m/s^2]

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("steering_lag", o.steering_lag, 0.0, 1.0, "s");
    row("drive_lag", o.drive_lag, 0.0, 1.0, "s");
    row("drive_acceleration", o.drive_acceleration, 0.01, 1000.0, "m/s^2");
  }
};

/// How the wheels fail to hold the ground.
struct SlipOptions
{
  double drive_slip = 0.0;    ///< share of the rolling speed by which the body falls behind [0..1)
  double lateral_slip = 0.0;  ///< slip angle for each m/s^2 of lateral acceleration, outward [rad s^2/m]

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("drive_slip", o.drive_slip, -0.9, 0.9);
    row("lateral_slip", o.lateral_slip, 0.0, 0.1, "rad s^2/m");
  }
};

/// What is measured of the wheels.
struct EncoderOptions
{
  double angle_resolution = 2.0 * M_PI / 16384;  ///< steps of a measured angle; 0: none [rad]
  double angle_noise = 0.0;                      ///< standard deviation [rad]
  double speed_resolution = 0.001;               ///< steps of a measured speed; 0: none [m/s]
  double speed_noise = 0.0;                      ///< standard deviation [m/s]

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("angle_resolution", o.angle_resolution, 0.0, 0.1, "rad");
    row("angle_noise", o.angle_noise, 0.0, 0.1, "rad");
    row("speed_resolution", o.speed_resolution, 0.0, 0.1, "m/s");
    row("speed_noise", o.speed_noise, 0.0, 0.1, "m/s");
  }
};

/// When wheels may turn and drive after a change of mode. The defaults are the bridge's.
struct InterlockOptions
{
  double largest_jump = M_PI * 20.0 / 180.0;  ///< of a commanded angle; beyond it is treated as another mode [rad]
  double standstill_speed = 0.005;            ///< every wheel is slower at standstill [m/s]
  double standstill_time = 0.1;               ///< for so long [s]
  double aligned_angle = M_PI * 2.0 / 180.0;  ///< every wheel is nearer to its angle when aligned [rad]
  double aligned_time = 0.05;                 ///< for so long [s]
  double alignment_timeout = 3.0;             ///< to come to rest, and again to be aligned; then it is a fault [s]

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("largest_jump", o.largest_jump, 0.01, 10.0, "rad");
    row("standstill_speed", o.standstill_speed, 1e-4, 1.0, "m/s");
    row("standstill_time", o.standstill_time, 0.0, 10.0, "s");
    row("aligned_angle", o.aligned_angle, 1e-4, 0.5, "rad");
    row("aligned_time", o.aligned_time, 0.0, 10.0, "s");
    row("alignment_timeout", o.alignment_timeout, 0.01, 3600.0, "s");
  }
};

/// The simulated base; the keys of config/simulator.yaml.
struct SimulatorOptions
{
  int seed = 1;                    ///< of all noise
  double time_step = 0.001;        ///< of the simulation [s]
  double command_latency = 0.02;   ///< from command() to the actuators [s]
  double command_timeout = 0.15;   ///< without a command the base stops [s]
  double stop_deceleration = 3.0;  ///< of the fastest wheel when the base stops by itself or is told to [m/s^2]
  ActuatorOptions actuators;
  SlipOptions slip;
  EncoderOptions encoders;
  InterlockOptions interlock;

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("seed", o.seed, 0, 1e9);
    row("time_step", o.time_step, 1e-4, 0.01, "s");
    row("command_latency", o.command_latency, 0.0, 2.0, "s");
    row("command_timeout", o.command_timeout, 0.01, 10.0, "s");
    row("stop_deceleration", o.stop_deceleration, 0.1, 100.0, "m/s^2");
    row.group("", o.actuators);
    row.group("", o.slip);
    row.group("", o.encoders);
    row.group("", o.interlock);
  }
};

/// Each throws std::invalid_argument naming key, value and range.
void check(const ActuatorOptions& options);
void check(const SlipOptions& options);
void check(const EncoderOptions& options);
void check(const InterlockOptions& options);
void check(const SimulatorOptions& options);

/// The same, and where the wheels of the robot could not align in time.
void check(const Robot& robot, const SimulatorOptions& options);

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
