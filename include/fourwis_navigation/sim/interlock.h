#pragma once

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/sim/simulator_options.h"

namespace fourwis
{

/// Keeps wheels that point somewhere else from driving: a command of another mode than the one before, or with angles
/// far from it, first waits for standstill, then turns the wheels, then waits until they are aligned, and only then
/// lets them drive. On a bus the bridge keeps this promise, by code of its own on purpose (src/can/bridge/interlock.h): neither
/// hides a mistake of the other. Rules and thresholds of both are those of doc/can_bridge.md.
class Interlock
{
public:
  enum class Stage
  {
    locked,          ///< no mode: wheels stop and hold their angles
    coming_to_rest,  ///< they do until they are at standstill
    aligning,        ///< at rest they turn
    released,        ///< they turn and drive
    failed           ///< they did not come so far in time; locked until reset()
  };

  /// Throws std::invalid_argument naming the option, its value and the range.
  explicit Interlock(const InterlockOptions& options);

  /// What the wheels are wanted to do from now on.
  void want(Mode mode, const PerWheel& angle);

  /// Lets time pass [s] in which this was measured.
  void step(double duration, const WheelMotion& measured);

  /// Back to `locked`.
  void reset();

  Stage stage() const { return stage_; }
  bool may_turn() const { return stage_ == Stage::aligning || stage_ == Stage::released; }
  bool may_drive() const { return stage_ == Stage::released; }
  bool at_standstill() const;
  /// The wheels may turn and have stayed near the angles wanted.
  bool aligned() const;

private:
  bool is_waiting() const;
  void advance();

  InterlockOptions options_;
  Stage stage_ = Stage::locked;
  Mode mode_ = Mode::none;
  PerWheel angle_{}, measured_angle_{};
  double standstill_ = 0.0, aligned_ = 0.0, waiting_ = 0.0;  ///< how long it has been so [s]
};

}  // namespace fourwis
