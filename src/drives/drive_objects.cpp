#include "drive_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace fourwis::drives
{
namespace
{

constexpr std::int64_t kLow32 = std::numeric_limits<std::int32_t>::min();
constexpr std::int64_t kHigh32 = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t kMost32 = std::numeric_limits<std::uint32_t>::max();

Object constant(std::uint8_t size, std::int64_t value)
{
  return {size, ObjectUse::constant, value, 0, 0};
}
Object setting(std::uint8_t size, std::int64_t value, std::int64_t low, std::int64_t high)
{
  return {size, ObjectUse::setting, value, low, high};
}
Object status(std::uint8_t size, std::int64_t low = 0)
{
  return {size, ObjectUse::status, 0, low, 0};
}
Object command(std::uint8_t size, std::int64_t low, std::int64_t high)
{
  return {size, ObjectUse::command, 0, low, high};
}

std::int64_t whole(double value)
{
  return std::llround(std::clamp(value, 1.0, static_cast<double>(kMost32)));
}

void add_errors(ObjectDictionary& objects)
{
  objects.add({object::kErrorRegister, 0}, status(1));
  objects.add({object::kErrorHistory, 0}, setting(1, 0, 0, 0));  // only emptied
  for (std::uint8_t k = 1; k <= kErrorsKept; ++k) objects.add({object::kErrorHistory, k}, constant(4, 0));
  objects.add({object::kErrorCode, 0}, status(2));
}

void add_node(ObjectDictionary& objects, const DriveOptions& options)
{
  objects.add({object::kDeviceType, 0}, constant(4, 0x00020192));  // a servo drive after CiA 402
  objects.add({object::kHeartbeatConsumer, 0}, constant(1, 1));
  objects.add({object::kHeartbeatConsumer, 1}, setting(4, 0, 0, 0x007FFFFF));
  objects.add({object::kHeartbeatProducer, 0}, setting(2, 0, 0, 0xFFFF));
  const std::array<std::uint32_t, 5> identity = {4, options.vendor, options.product, 1, options.serial};
  std::uint8_t sub = 0;
  for (std::uint32_t value : identity)
  {
    objects.add({object::kIdentity, sub}, constant(sub == 0 ? 1 : 4, value));
    ++sub;
  }
  objects.add({object::kErrorBehaviour, 0}, constant(1, 1));
  objects.add({object::kErrorBehaviour, 1}, setting(1, 0, 0, 2));
}

void add_pdo(ObjectDictionary& objects, std::uint16_t parameters, std::uint8_t highest, std::uint32_t cob)
{
  objects.add({parameters, 0}, constant(1, highest));
  objects.add({parameters, 1}, setting(4, cob, 0, kMost32));
  objects.add({parameters, 2}, setting(1, 255, 0, 255));
  if (highest < 5) return;
  objects.add({parameters, 3}, setting(2, 0, 0, 0xFFFF));
  objects.add({parameters, 5}, setting(2, 0, 0, 0xFFFF));
}

void add_mapping(ObjectDictionary& objects, std::uint16_t mapping, std::initializer_list<std::uint32_t> mapped)
{
  objects.add({mapping, 0}, setting(1, static_cast<std::int64_t>(mapped.size()), 0, kMappedObjects));
  for (std::uint8_t k = 1; k <= kMappedObjects; ++k)
    objects.add({mapping, k}, setting(4, k <= mapped.size() ? mapped.begin()[k - 1] : 0, 0, kMost32));
}

/// The default mappings of CiA 402.
void add_pdos(ObjectDictionary& objects, std::uint8_t node)
{
  for (std::uint16_t k = 0; k < kPdos; ++k)
  {
    const std::uint32_t off = k == 0 ? 0 : kPdoInvalid;
    const std::uint16_t receive = object::kReceiveParameters + k, transmit = object::kTransmitParameters + k;
    add_pdo(objects, receive, 2, off | (0x200u + 0x100u * k + node));
    add_pdo(objects, transmit, 5, off | (0x180u + 0x100u * k + node));
  }
  add_mapping(objects, object::kReceiveMapping, {0x60400010});
  add_mapping(objects, object::kReceiveMapping + 1, {0x60400010, 0x60600008});
  add_mapping(objects, object::kReceiveMapping + 2, {0x60400010, 0x607A0020});
  add_mapping(objects, object::kReceiveMapping + 3, {0x60400010, 0x60FF0020});
  add_mapping(objects, object::kTransmitMapping, {0x60410010});
  add_mapping(objects, object::kTransmitMapping + 1, {0x60410010, 0x60610008});
  add_mapping(objects, object::kTransmitMapping + 2, {0x60410010, 0x60640020});
  add_mapping(objects, object::kTransmitMapping + 3, {0x60410010, 0x606C0020});
}

void add_power(ObjectDictionary& objects)
{
  objects.add({object::kControlword, 0}, command(2, 0, 0xFFFF));
  objects.add({object::kStatusword, 0}, status(2));
  objects.add({object::kMode, 0}, command(1, -128, 127));
  objects.add({object::kModeDisplay, 0}, status(1, -128));
  objects.add({object::kSupportedModes, 0}, constant(4, 0x1A5));  // PP, PV, homing, CSP, CSV
  objects.add({object::kAbortConnection, 0}, setting(2, 0, -32768, 32767));
  objects.add({object::kQuickStopOption, 0}, setting(2, 2, -32768, 32767));
  objects.add({object::kHaltOption, 0}, setting(2, 1, -32768, 32767));
  objects.add({object::kFaultReactionOption, 0}, setting(2, 2, -32768, 32767));
}

void add_motion(ObjectDictionary& objects, const DriveOptions& options)
{
  objects.add({object::kPositionActual, 0}, status(4, kLow32));
  objects.add({object::kVelocityActual, 0}, status(4, kLow32));
  objects.add({object::kTorqueActual, 0}, status(2, -32768));
  objects.add({object::kSupplyVoltage, 0}, constant(4, 48000));  // [mV]
  objects.add({object::kTargetPosition, 0}, command(4, kLow32, kHigh32));
  objects.add({object::kTargetVelocity, 0}, command(4, kLow32, kHigh32));
  objects.add({object::kFollowingWindow, 0}, setting(4, whole(options.following_window), 0, kMost32));
  objects.add({object::kFollowingTime, 0}, setting(2, options.following_time, 0, 0xFFFF));
  objects.add({object::kSoftLimits, 0}, constant(1, 2));
  for (std::uint8_t k = 1; k <= 2; ++k) objects.add({object::kSoftLimits, k}, setting(4, 0, kLow32, kHigh32));
  objects.add({object::kProfileVelocity, 0}, setting(4, whole(options.profile_velocity), 0, kMost32));
  objects.add({object::kProfileAcceleration, 0}, setting(4, whole(options.acceleration), 1, kMost32));
  objects.add({object::kProfileDeceleration, 0}, setting(4, whole(options.acceleration), 1, kMost32));
  objects.add({object::kQuickStopDeceleration, 0}, setting(4, whole(options.quick_stop), 1, kMost32));
  objects.add({object::kInterpolationPeriod, 0}, constant(1, 2));
  objects.add({object::kInterpolationPeriod, 1}, setting(1, 1, 1, 255));
  objects.add({object::kInterpolationPeriod, 2}, setting(1, -3, -6, 0));
}

void add_homing(ObjectDictionary& objects)
{
  objects.add({object::kHomeOffset, 0}, setting(4, 0, kLow32, kHigh32));
  objects.add({object::kHomingMethod, 0}, setting(1, 0, -128, 127));
  objects.add({object::kHomingSpeeds, 0}, constant(1, 2));
  for (std::uint8_t k = 1; k <= 2; ++k) objects.add({object::kHomingSpeeds, k}, setting(4, 1000, 0, kMost32));
}

/// The allowed values of settings that have only a few.
const std::vector<std::int64_t>* values_known(std::uint16_t index)
{
  using namespace mode_of_operation;
  static const std::map<std::uint16_t, std::vector<std::int64_t>> known = {
      {object::kAbortConnection, {0, 1, 2, 3}},
      {object::kQuickStopOption, {0, 1, 2, 5, 6}},
      {object::kHaltOption, {1, 2}},
      {object::kFaultReactionOption, {0, 1, 2}},
      {object::kHomingMethod, {0, 34, 35, 37}},
      {object::kMode, {kNone, kProfilePosition, kProfileVelocity, kHoming, kCyclicPosition, kCyclicVelocity}}};
  const auto found = known.find(index);
  return found == known.end() ? nullptr : &found->second;
}

AbortCode reject_unknown_value(const ObjectDictionary&, ObjectAddress address, std::int64_t value)
{
  const auto* known = values_known(address.index);
  if (known == nullptr || std::find(known->begin(), known->end(), value) != known->end()) return AbortCode::none;
  return AbortCode::invalid_value;
}

}  // namespace

ObjectDictionary drive_objects(const DriveOptions& options)
{
  ObjectDictionary objects;
  add_node(objects, options);
  add_errors(objects);
  add_pdos(objects, options.node);
  add_power(objects);
  add_motion(objects, options);
  add_homing(objects);
  objects.add_rule(reject_unknown_value);
  return objects;
}

}  // namespace fourwis::drives
