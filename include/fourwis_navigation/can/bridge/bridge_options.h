#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "fourwis_navigation/model/option_range.h"
#include "fourwis_navigation/model/option_text.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::can
{

/// What a wheel's radius may be.
inline constexpr OptionRange kWheelRadii{0.01, 2.0, "m"};

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
  int node = 0;                      ///< CANopen node id
  double counts_per_turn = 65536.0;  ///< encoder counts in a turn of the motor
  double gear_ratio = 1.0;           ///< turns of the motor for one turn of the axis
  bool reversed = false;             ///< counts grow where our angle or speed falls
  double offset = 0.0;               ///< steering only: the wheel's angle at count 0 [rad]

  /// The table of the options but `offset`; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("node", o.node, 1, 127);
    row("counts_per_turn", o.counts_per_turn, 1.0, 1e9, "counts");
    row("gear_ratio", o.gear_ratio, 1e-3, 1e4);
    row("reversed", o.reversed);
  }
};

/// In wheel order.
using WheelAxes = std::array<AxisOptions, kWheels>;

inline AxisOptions axis(int node, double gear_ratio)
{
  AxisOptions options;
  options.node = node;
  options.gear_ratio = gear_ratio;
  return options;
}

/// What keys call the wheels, in wheel order.
inline constexpr std::array<const char*, kWheels> kWheelNames = {"front_left", "front_right", "rear_left",
                                                                 "rear_right"};

/// What differs between the bases that speak the Ranger protocol.
struct RangerOptions
{
  std::array<int, kWheels> place = {1, 2, 3, 4};  ///< of each of our wheels among the base's four, from 1
  int side_slip_mode = 4;                         ///< its number for side-slip; 3 on the Mini V1
  bool spin_by_speed = false;  ///< spin is commanded as the wheels' speed in the lateral field; Mini V2

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    for (std::size_t i = 0; i < kWheels; ++i) row(std::string("place/") + kWheelNames[i], o.place[i], 1, kWheels);
    row("side_slip_mode", o.side_slip_mode, 3, 255);  // the other modes have the numbers 0 to 2
    row("spin_by_speed", o.spin_by_speed);
  }
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
  std::uint32_t vendor_id = 0;           ///< that every drive must have (1018:1); 0: any
  std::uint32_t product_code = 0;        ///< that every drive must have (1018:2); 0: any
  std::uint32_t temperature_object = 0;  ///< of the maker's own, index << 8 | sub-index; 0: none
  double temperature_unit = 1.0;         ///< what its value counts in [deg C]
  bool homing = false;                   ///< steering drives search their zero before the first motion after each start
  int homing_method = 24;                ///< object 6098; one that searches, 24: for a home switch

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

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("interface", o.interface, Word{});
    row("protocol", o.protocol, OneOf{"cia402", "ranger"});
    row("bit_rate", o.bit_rate, 10000, 1000000, "bit/s");
    row("cycle_time", o.cycle_time, 0.001, 0.1, "s");
    row("master_node", o.master_node, 1, 127);
    describe_drives(o, row);
    row.group("ranger/", o.ranger);
    row("max_acceleration", o.max_acceleration, 0.01, 1000.0, "m/s^2");
    row("stop_deceleration", o.stop_deceleration, 0.1, 1000.0, "m/s^2");
    row("standstill_speed", o.standstill_speed, 1e-4, 1.0, "m/s");
    row("standstill_time", o.standstill_time, 0.0, 10.0, "s");
    row("aligned_tolerance", o.aligned_tolerance, 1e-3, 0.5, "rad");
    row("aligned_time", o.aligned_time, 0.0, 10.0, "s");
    row("command_timeout", o.command_timeout, 0.01, 10.0, "s");
    row("heartbeat_period", o.heartbeat_period, 0.005, 1.0, "s");
    row("heartbeat_timeout", o.heartbeat_timeout, 0.01, 10.0, "s");
    row("drive_watchdog", o.drive_watchdog, 0.01, 10.0, "s");
    row("feedback_timeout", o.feedback_timeout, 0.002, 10.0, "s");
    row("boot_timeout", o.boot_timeout, 0.1, 600.0, "s");
    row("sdo_timeout", o.sdo_timeout, 0.01, 60.0, "s");
    row("enable_timeout", o.enable_timeout, 0.1, 600.0, "s");
    row("homing_timeout", o.homing_timeout, 0.1, 3600.0, "s");
    row("alignment_timeout", o.alignment_timeout, 0.1, 600.0, "s");
    row("stop_timeout", o.stop_timeout, 0.1, 600.0, "s");
    row("following_time", o.following_time, 0.01, 10.0, "s");
    row("steering_error", o.steering_error, 0.01, 3.0, "rad");
    row("speed_error", o.speed_error, 0.01, 100.0, "m/s");
  }

private:
  template <class Self, class Row>
  static void describe_drives(Self& o, Row& row)
  {
    for (std::size_t i = 0; i < kWheels; ++i)
    {
      const std::string steering = std::string("steering/") + kWheelNames[i] + '/';
      row.group(steering, o.steering[i]);
      row(steering + "offset", o.steering[i].offset, -10.0, 10.0, "rad");
    }
    for (std::size_t i = 0; i < kWheels; ++i) row.group(std::string("driving/") + kWheelNames[i] + '/', o.driving[i]);
    row("wheel_radius", o.wheel_radius, kWheelRadii.least, kWheelRadii.greatest, kWheelRadii.unit);
    row("steering_mode", o.steering_mode, OneOf{"cyclic", "profile"});
    row("driving_mode", o.driving_mode, OneOf{"cyclic", "profile"});
    row("vendor_id", o.vendor_id, 0, 4294967295.0);
    row("product_code", o.product_code, 0, 4294967295.0);
    row("temperature_object", o.temperature_object, 0, 16777215);
    row("temperature_unit", o.temperature_unit, 0.001, 100.0, "deg C");
    row("homing", o.homing);
    row("homing_method", o.homing_method, -128, 127);
  }
};

/// Throws std::invalid_argument, naming key, value and what was expected, where one is out of range or some contradict each
/// other.
void check(const BridgeOptions& options);

/// The same, and where they contradict the robot or ask for more than a drive's numbers can say.
void check(const Robot& robot, const BridgeOptions& options);

}  // namespace fourwis::can
