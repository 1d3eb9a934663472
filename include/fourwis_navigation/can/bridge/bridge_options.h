#pragma once

#include <array>
#include <cmath>
#include <string>

#include "fourwis_navigation/model/robot.h"

namespace fourwis::can
{

/// What the base speaks.
enum class Protocol
{
  cia402,  ///< CANopen drives after CiA 402, two for each wheel
  ranger   ///< AgileX Ranger, protocol v2
};

/// How a steering drive is moved.
enum class SteeringMode
{
  cyclic,  ///< cyclic synchronous position, 8
  profile  ///< profile position, 1
};

/// How a driving drive is moved.
enum class DrivingMode
{
  cyclic,  ///< cyclic synchronous velocity, 9
  profile  ///< profile velocity, 3
};

/// One drive on the bus, and what its counts mean. A turn of the axis (of the steering column, of the wheel) is
/// counts_per_turn * gear_ratio counts.
struct AxisOptions
{
  int node = 0;                      ///< CANopen node id, 1 to 126
  double counts_per_turn = 65536.0;  ///< encoder counts in a turn of the motor
  double gear_ratio = 1.0;           ///< turns of the motor for one turn of the axis
  bool reversed = false;             ///< counts grow where our angle or speed falls
  double offset = 0.0;               ///< steering only: the wheel's angle at count 0 [rad]
};

/// In wheel order: front-left, front-right, rear-left, rear-right.
using WheelAxes = std::array<AxisOptions, kWheels>;

inline AxisOptions axis(int node, double gear_ratio)
{
  AxisOptions options;
  options.node = node;
  options.gear_ratio = gear_ratio;
  return options;
}

/// What differs between the bases that speak the Ranger protocol.
struct RangerOptions
{
  std::array<int, kWheels> place = {1, 2, 3, 4};  ///< of each of our wheels among the base's four, from 1
  int side_slip_mode = 4;                         ///< its number for side-slip; 3 on the Mini V1
  bool spin_by_speed = false;  ///< spin is commanded as the wheels' speed in the lateral field; Mini V2
};

/// The base and how it is driven; the keys of config/can_bridge.yaml. What the wheels can do is in Robot: travel,
/// steering rate, speed.
struct BridgeOptions
{
  std::string interface = "can0";  ///< see open_bus()
  Protocol protocol = Protocol::cia402;
  int bit_rate = 500000;     ///< of the bus, for its load only: the interface is set up elsewhere [bit/s]
  double cycle_time = 0.01;  ///< between two SYNC [s]
  int master_node = 127;     ///< our own node id, of our heartbeat

  WheelAxes steering = {axis(1, 60.0), axis(2, 60.0), axis(3, 60.0), axis(4, 60.0)};
  WheelAxes driving = {axis(5, 20.0), axis(6, 20.0), axis(7, 20.0), axis(8, 20.0)};
  double wheel_radius = 0.1;  ///< [m]
  SteeringMode steering_mode = SteeringMode::cyclic;
  DrivingMode driving_mode = DrivingMode::cyclic;
  double vendor_id = 0.0;           ///< that every drive must have (1018:1); 0: any
  double product_code = 0.0;        ///< that every drive must have (1018:2); 0: any
  double temperature_object = 0.0;  ///< of the maker's own, index << 8 | sub-index; 0: none
  double temperature_unit = 1.0;    ///< what its value counts in [deg C]
  bool homing = false;              ///< steering drives search their zero before the first motion after each start
  int homing_method = 24;           ///< object 6098; one that searches, 24: for a home switch

  RangerOptions ranger;  ///< for Protocol::ranger

  // Motion.
  double max_acceleration = 12.0;   ///< of a wheel; the fastest wheel is faster than the centre [m/s^2]
  double stop_deceleration = 5.0;   ///< of the fastest wheel in a controlled stop, and of the drives' own [m/s^2]
  double standstill_speed = 0.005;  ///< a wheel slower than this stands [m/s]
  double standstill_time = 0.1;     ///< so long, before the wheels may turn to another mode [s]
  double aligned_tolerance = 2.0 * M_PI / 180.0;  ///< of each wheel's angle [rad]
  double aligned_time = 0.05;                     ///< so long, before the wheels may drive [s]

  // Watchdogs.
  double command_timeout = 0.15;                ///< a command older than this stops the base [s]
  double heartbeat_period = 0.05;               ///< of our heartbeat and of each drive's [s]
  double heartbeat_timeout = 0.15;              ///< a drive without heartbeat for so long is lost [s]
  double drive_watchdog = 0.1;                  ///< a drive that does not hear us for so long stops by itself [s]
  double feedback_timeout = 0.05;               ///< a drive whose cyclic frames are missing for so long is lost [s]
  double boot_timeout = 5.0;                    ///< for each drive to appear [s]
  double sdo_timeout = 0.1;                     ///< for an answer to a request, which is then repeated twice [s]
  double enable_timeout = 2.0;                  ///< for the drives to be enabled or disabled [s]
  double homing_timeout = 20.0;                 ///< [s]
  double alignment_timeout = 3.0;               ///< for the wheels to reach commanded angles at standstill [s]
  double stop_timeout = 3.0;                    ///< to come to rest, before the drives are disabled all the same [s]
  double following_time = 0.3;                  ///< a wheel that is off for longer than this is faulty [s]
  double steering_error = 10.0 * M_PI / 180.0;  ///< off: this far from where it was told to be [rad]
  double speed_error = 0.3;                     ///< off: this much faster or slower than it was told to be [m/s]
};

}  // namespace fourwis::can
