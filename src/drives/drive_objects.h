#pragma once

#include "fourwis_navigation/drives/drive_options.h"
#include "fourwis_navigation/drives/object_dictionary.h"

namespace fourwis::drives
{

/// Objects of CiA 301.
namespace object
{
inline constexpr std::uint16_t kDeviceType = 0x1000, kErrorRegister = 0x1001, kErrorHistory = 0x1003,
                               kHeartbeatConsumer = 0x1016, kHeartbeatProducer = 0x1017, kIdentity = 0x1018,
                               kErrorBehaviour = 0x1029, kReceiveParameters = 0x1400, kReceiveMapping = 0x1600,
                               kTransmitParameters = 0x1800, kTransmitMapping = 0x1A00;
/// Objects of CiA 402.
inline constexpr std::uint16_t kAbortConnection = 0x6007, kErrorCode = 0x603F, kControlword = 0x6040,
                               kStatusword = 0x6041, kQuickStopOption = 0x605A, kHaltOption = 0x605D,
                               kFaultReactionOption = 0x605E, kMode = 0x6060, kModeDisplay = 0x6061,
                               kPositionActual = 0x6064, kFollowingWindow = 0x6065, kFollowingTime = 0x6066,
                               kVelocityActual = 0x606C, kTorqueActual = 0x6077, kSupplyVoltage = 0x6079,
                               kTargetPosition = 0x607A, kHomeOffset = 0x607C, kSoftLimits = 0x607D,
                               kProfileVelocity = 0x6081, kProfileAcceleration = 0x6083, kProfileDeceleration = 0x6084,
                               kQuickStopDeceleration = 0x6085, kHomingMethod = 0x6098, kHomingSpeeds = 0x6099,
                               kInterpolationPeriod = 0x60C2, kTargetVelocity = 0x60FF, kSupportedModes = 0x6502;
}  // namespace object

/// Number of PDOs in each direction, and of objects that can be mapped into one.
inline constexpr int kPdos = 4, kMappedObjects = 8;
/// Number of errors that 1003 keeps.
inline constexpr int kErrorsKept = 4;
/// A PDO whose COB-ID has this bit does not exist.
inline constexpr std::uint32_t kPdoInvalid = 0x80000000;

/// Modes of operation (6060).
namespace mode_of_operation
{
inline constexpr int kNone = 0, kProfilePosition = 1, kProfileVelocity = 3, kHoming = 6, kCyclicPosition = 8,
                     kCyclicVelocity = 9;
}

/// All objects of a drive at power-on: RPDO1 is mapped to the controlword, TPDO1 to the statusword, the others are off.
ObjectDictionary drive_objects(const DriveOptions& options);

}  // namespace fourwis::drives
