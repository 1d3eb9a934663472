#pragma once

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/sim/simulator_options.h"

namespace fourwis
{

/// Prevents that wheels drive before they point in the commanded direction. A command of another mode, or with angles
/// far from those of the command before, first waits for standstill, then turns the wheels, then waits until they are
/// aligned, and only then lets them drive. For a base on a bus the bridge does the same, with separate code on purpose
/// (src/can/bridge/interlock.h), so that a mistake in one of them is noticed. doc/can_bridge.md has the rules and
/// thresholds of both.
class Interlock
{
public:
  enum class Stage
  {
    locked,          ///< no mode: wheels stop and hold their angles
    coming_to_rest,  ///< wheels stop and hold their angles until they are at standstill
    aligning,        ///< wheels turn at rest
    released,        ///< wheels turn and drive
    failed           ///< wheels did not stop or align in time; locked until reset()
  };

  /// Throws as check() does.
  explicit Interlock(const InterlockOptions& options);

  /// Sets the commanded mode and angles.
  void command(Mode mode, const PerWheel& angle);

  /// Advances the time by `duration` [s], in which `measured` was measured.
  void step(double duration, const WheelMotion& measured);

  /// Back to `locked`.
  void reset();

  Stage stage() const { return stage_; }
  bool may_turn() const { return stage_ == Stage::aligning || stage_ == Stage::released; }
  bool may_drive() const { return stage_ == Stage::released; }
  bool at_standstill() const;
  /// Whether the wheels may turn and have been near the commanded angles for long enough.
  bool aligned() const;

private:
  bool is_waiting() const;
  void advance();

  InterlockOptions options_;
  Stage stage_ = Stage::locked;
  Mode mode_ = Mode::none;
  PerWheel angle_{}, measured_angle_{};
  double standstill_ = 0.0, aligned_ = 0.0, waiting_ = 0.0;  ///< for how long each condition has been true [s]
};

}  // namespace fourwis
