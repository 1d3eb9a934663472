#pragma once

#include <cstdint>
#include <vector>

#include "axis_scale.h"
#include "fourwis_navigation/can/bridge/faults.h"
#include "fourwis_navigation/can/protocol/cia402.h"
#include "fourwis_navigation/can/protocol/sdo.h"

namespace fourwis::can
{

/// One step of a drive's start-up: an object is read and compared, or written.
struct SdoStep
{
  enum class Kind
  {
    expect_equal,  ///< read it; its value must be `value`
    expect_bits,   ///< read it; all bits of `value` must be set
    write,         ///< write `value`, read it back
    write_only     ///< write `value`; it may read back as another value
  };
  Kind kind = Kind::write;
  ObjectId object;
  std::uint32_t value = 0;
  int size = 4;                              ///< bytes of the object
  std::uint32_t compared = 0xFFFFFFFF;       ///< the bits that must read back as written
  bool optional = false;                     ///< a drive may lack the object
  Fault mismatch = Fault::setting_not_kept;  ///< the fault when the value read is another
};

using SdoScript = std::vector<SdoStep>;

/// Checks the identity and the abilities of the drive.
SdoScript identification_script(const BridgeOptions& options, bool steering);

/// Writes its PDOs, watchdogs, ramps and limits.
SdoScript configuration_script(const Robot& robot, const BridgeOptions& options, const AxisOptions& axis,
                               bool steering);

/// The mode of operation while driving.
OperationMode working_mode(const BridgeOptions& options, bool steering);

/// The limits of the ramps that a drive generates by itself.
struct Ramps
{
  double speed = 0.0;         ///< [rad/s or m/s]
  double acceleration = 0.0;  ///< also of braking [rad/s^2 or m/s^2]
  double deceleration = 0.0;  ///< of a quick stop
};
Ramps ramps_of(const Robot& robot, const BridgeOptions& options, bool steering);

/// How fast a steering drive searches its zero at first [rad/s].
double homing_rate(const Robot& robot);

/// The conversion of its counts.
AxisScale scale_of(const BridgeOptions& options, const AxisOptions& axis, bool steering);

}  // namespace fourwis::can
