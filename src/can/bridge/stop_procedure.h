#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "steady.h"

namespace fourwis::can
{

/// Brings a base to rest and then its drives out of operation. The wheels brake with their angles held. When they
/// stand, or after `stop_timeout`, the drives are disabled.
class StopProcedure
{
public:
  enum class Kind
  {
    none,
    ramp,  ///< the bridge reduces the speeds by its ramp
    brake  ///< speed 0 at once, the drives brake by their own ramp
  };
  enum class Phase
  {
    idle,
    braking,
    releasing,  ///< the drives are being disabled
    done
  };

  explicit StopProcedure(const BridgeOptions& options)
    : speed_(options.standstill_speed),
      timeout_(options.stop_timeout),
      standstill_(options.standstill_time)
  {}

  /// Begins a stop. A stop under way can become harder, not softer.
  void begin(Kind kind, double now);
  void cancel();

  /// Once a cycle, with the measured and the commanded speed of the fastest wheel [m/s]. `off`: all drives are out of
  /// operation.
  void update(double measured, double commanded, bool off, double now);

  Kind kind() const { return kind_; }
  Phase phase() const { return phase_; }

private:
  double speed_, timeout_;
  Steady standstill_;
  Kind kind_ = Kind::none;
  Phase phase_ = Phase::idle;
  double begun_ = 0.0;
};

}  // namespace fourwis::can
