#include "sdo_script.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fourwis_navigation/can/protocol/cia301.h"

namespace fourwis::can
{
namespace
{

using Kind = SdoStep::Kind;

/// Bits of a PDO's identifier: the PDO does not exist; no remote request, which some drives set by themselves.
constexpr std::uint32_t kInvalid = 1u << 31, kNoRemote = 1u << 30;
constexpr std::uint32_t kEverySync = 1;
/// Objects in the form of a PDO mapping: index, sub-index, number of bits.
constexpr std::uint32_t kControlword = 0x60400010, kMode = 0x60600008, kTargetPosition = 0x607A0020,
                        kTargetVelocity = 0x60FF0020, kStatusword = 0x60410010, kModeDisplay = 0x60610008,
                        kPosition = 0x60640020, kVelocity = 0x606C0020;
/// Values of 6007: quick stop; of 605A and 605E: brake by the ramp, then without torque; of 1029:1: to the state
/// `stopped`.
constexpr std::uint32_t kQuickStop = 3, kRampThenDisable = 2, kBecomeStopped = 2;
/// Time in which a drive stops a steering axis by itself [s].
constexpr double kSteeringStopTime = 0.2;
/// Homing is slower than steering by this factor, and the search of the zero is slower by this factor once more.
constexpr double kHomingSlowness = 10.0;
constexpr double kMostCounts = std::numeric_limits<std::uint32_t>::max();

SdoStep write(ObjectId object, std::uint32_t value, int size)
{
  SdoStep step;
  step.object = object;
  step.value = value;
  step.size = size;
  return step;
}

SdoStep write_if_there(ObjectId object, std::uint32_t value, int size)
{
  SdoStep step = write(object, value, size);
  step.optional = true;
  return step;
}

SdoStep write_only(ObjectId object, std::uint32_t value, int size)
{
  SdoStep step = write(object, value, size);
  step.kind = Kind::write_only;
  return step;
}

SdoStep expect(Kind kind, ObjectId object, std::uint32_t value, Fault mismatch)
{
  SdoStep step = write(object, value, 4);
  step.kind = kind;
  step.mismatch = mismatch;
  return step;
}

/// A number of 0 accepts every identity except 0.
SdoStep expect_identity(ObjectId object, std::uint32_t value)
{
  return expect(value != 0 ? Kind::expect_equal : Kind::expect_bits, object, value, Fault::wrong_device);
}

std::uint32_t bit_of(OperationMode mode)
{
  return 1u << (static_cast<int>(mode) - 1);
}

std::uint32_t milliseconds(double seconds)
{
  return static_cast<std::uint32_t>(std::lround(seconds * 1e3));
}

/// A positive number of counts, for objects without a sign.
std::uint32_t magnitude(const AxisScale& scale, double rate)
{
  return static_cast<std::uint32_t>(std::clamp(std::round(std::abs(rate * scale.counts_per_unit())), 1.0, kMostCounts));
}

/// `parameters` 14xx or 18xx, `mapping` 16xx or 1Axx.
void add_pdo(SdoScript& script, std::uint16_t parameters, std::uint16_t mapping, std::uint32_t id,
             const std::vector<std::uint32_t>& objects)
{
  const auto count = static_cast<std::uint32_t>(objects.size());
  script.push_back(write_only({parameters, 1}, id | kInvalid, 4));
  script.push_back(write_only({mapping, 0}, 0, 1));
  for (std::uint8_t i = 0; i < count; ++i)
    script.push_back(write({mapping, static_cast<std::uint8_t>(i + 1)}, objects[i], 4));
  script.push_back(write({mapping, 0}, count, 1));
  script.push_back(write({parameters, 2}, kEverySync, 1));
  script.push_back(write({parameters, 1}, id, 4));
  script.back().compared = ~kNoRemote;
}

void add_pdos(SdoScript& script, int node, bool steering)
{
  add_pdo(script, 0x1400, 0x1600, cob_id(Service::rpdo1, node),
          {kControlword, kMode, steering ? kTargetPosition : kTargetVelocity});
  add_pdo(script, 0x1800, 0x1A00, cob_id(Service::tpdo1, node), {kStatusword, kModeDisplay});
  add_pdo(script, 0x1801, 0x1A01, cob_id(Service::tpdo2, node), {kPosition, kVelocity});
}

/// The drive stops by itself when our heartbeat is missing.
void add_watchdogs(SdoScript& script, const BridgeOptions& options)
{
  script.push_back(write({0x605A, 0}, kRampThenDisable, 2));
  script.push_back(write_if_there({0x605E, 0}, kRampThenDisable, 2));
  script.push_back(write({0x6007, 0}, kQuickStop, 2));
  script.push_back(write({0x1029, 1}, kBecomeStopped, 1));
  script.push_back(write({0x1017, 0}, milliseconds(options.heartbeat_period), 2));
  const auto master = static_cast<std::uint32_t>(options.master_node);
  script.push_back(write({0x1016, 1}, master << 16 | milliseconds(options.drive_watchdog), 4));
}

void add_cycle_time(SdoScript& script, const BridgeOptions& options)
{
  script.push_back(write_if_there({0x60C2, 1}, milliseconds(options.cycle_time), 1));
  script.push_back(write_if_there({0x60C2, 2}, static_cast<std::uint32_t>(-3), 1));
  script.back().compared = 0xFF;
}

void add_ramps(SdoScript& script, const AxisScale& scale, const Ramps& ramps)
{
  script.push_back(write_if_there({0x6081, 0}, magnitude(scale, ramps.speed), 4));
  script.push_back(write_if_there({0x6083, 0}, magnitude(scale, ramps.acceleration), 4));
  script.push_back(write_if_there({0x6084, 0}, magnitude(scale, ramps.acceleration), 4));
  script.push_back(write({0x6085, 0}, magnitude(scale, ramps.deceleration), 4));
}

void add_travel(SdoScript& script, const AxisScale& scale, double max_angle)
{
  const auto [least, greatest] = std::minmax({scale.to_counts(-max_angle), scale.to_counts(max_angle)});
  script.push_back(write_if_there({0x607D, 1}, static_cast<std::uint32_t>(least), 4));
  script.push_back(write_if_there({0x607D, 2}, static_cast<std::uint32_t>(greatest), 4));
}

void add_homing(SdoScript& script, const AxisScale& scale, int method, double rate)
{
  const std::uint32_t fast = magnitude(scale, rate);
  script.push_back(write({0x6098, 0}, static_cast<std::uint32_t>(method), 1));
  script.back().compared = 0xFF;
  script.push_back(write_if_there({0x6099, 1}, fast, 4));
  script.push_back(write_if_there({0x6099, 2}, fast / static_cast<std::uint32_t>(kHomingSlowness), 4));
}

}  // namespace

OperationMode working_mode(const BridgeOptions& options, bool steering)
{
  if (steering)
    return options.steering_mode == SteeringMode::cyclic ? OperationMode::cyclic_position
                                                         : OperationMode::profile_position;
  return options.driving_mode == DrivingMode::cyclic ? OperationMode::cyclic_velocity : OperationMode::profile_velocity;
}

Ramps ramps_of(const Robot& robot, const BridgeOptions& options, bool steering)
{
  const double steering_stop = robot.wheel_max_rate / kSteeringStopTime;
  if (steering) return {robot.wheel_max_rate, steering_stop, steering_stop};
  return {robot.wheel_max_speed, options.max_acceleration, options.stop_deceleration};
}

double homing_rate(const Robot& robot)
{
  return robot.wheel_max_rate / kHomingSlowness;
}

AxisScale scale_of(const BridgeOptions& options, const AxisOptions& axis, bool steering)
{
  return steering ? AxisScale::steering(axis) : AxisScale::driving(axis, options.wheel_radius);
}

SdoScript identification_script(const BridgeOptions& options, bool steering)
{
  SdoScript script;
  script.push_back(expect_identity({0x1018, 1}, options.vendor_id));
  script.push_back(expect_identity({0x1018, 2}, options.product_code));
  std::uint32_t modes = bit_of(working_mode(options, steering));
  if (steering && options.homing) modes |= bit_of(OperationMode::homing);
  script.push_back(expect(Kind::expect_bits, {0x6502, 0}, modes, Fault::mode_unsupported));
  return script;
}

SdoScript configuration_script(const Robot& robot, const BridgeOptions& options, const AxisOptions& axis, bool steering)
{
  const AxisScale scale = scale_of(options, axis, steering);
  SdoScript script;
  add_pdos(script, axis.node, steering);
  add_ramps(script, scale, ramps_of(robot, options, steering));
  if (steering)
  {
    add_travel(script, scale, robot.wheel_max_angle);
    if (options.homing) add_homing(script, scale, options.homing_method, homing_rate(robot));
  }
  add_cycle_time(script, options);
  add_watchdogs(script, options);
  return script;
}

}  // namespace fourwis::can
