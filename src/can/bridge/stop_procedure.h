#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "steady.h"

namespace fourwis::can
{

/// Brings a base to rest and then its drives out of operation: the wheels roll out with their angles held, and when
/// they stand, or after too long, the drives are disabled.
class StopProcedure
{
public:
  enum class Kind
  {
    none,
    ramp,  ///< the speeds come down by our ramp
    brake  ///< speed zero at once, the drives brake by their own ramp
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

  /// Begins, or becomes harder than it was.
  void begin(Kind kind, double now);
  void cancel();

  /// Goes on: `speed` of the fastest wheel, measured and commanded [m/s]; whether all drives are out of operation.
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
