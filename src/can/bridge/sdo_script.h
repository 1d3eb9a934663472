#pragma once

#include <cstdint>
#include <vector>

#include "axis_scale.h"
#include "fourwis_navigation/can/bridge/faults.h"
#include "fourwis_navigation/can/protocol/cia402.h"
#include "fourwis_navigation/can/protocol/sdo.h"

namespace fourwis::can
{

/// One thing to be done with an object of a drive before it may work.
struct SdoStep
{
  enum class Kind
  {
    expect_equal,  ///< read it; it must be `value`
    expect_bits,   ///< read it; all bits of `value` must be set
    write,         ///< write `value`, read it back
    write_only     ///< write `value`; it may read as something else
  };
  Kind kind = Kind::write;
  ObjectId object;
  std::uint32_t value = 0;
  int size = 4;                             ///< bytes of the object
  std::uint32_t compared = 0xFFFFFFFF;      ///< the bits that must read as written
  bool optional = false;                    ///< a drive without the object is good enough
  Fault refusal = Fault::setting_not_kept;  ///< what it is when the value read is another
};

using SdoScript = std::vector<SdoStep>;

/// Who the drive is and what it can do.
SdoScript identification_script(const BridgeOptions& options, bool steering);

/// Its PDOs, its watchdogs, its ramps and limits.
SdoScript configuration_script(const Robot& robot, const BridgeOptions& options, const AxisOptions& axis,
                               bool steering);

/// The mode it will work in.
OperationMode working_mode(const BridgeOptions& options, bool steering);

/// How fast a drive may become, and how hard it may change its speed where it does so by its own ramps.
struct Ramps
{
  double speed = 0.0;         ///< [rad/s or m/s]
  double acceleration = 0.0;  ///< also of braking [rad/s^2 or m/s^2]
  double deceleration = 0.0;  ///< of a quick stop
};
Ramps ramps_of(const Robot& robot, const BridgeOptions& options, bool steering);

/// What its counts mean.
AxisScale scale_of(const BridgeOptions& options, const AxisOptions& axis, bool steering);

}  // namespace fourwis::can
