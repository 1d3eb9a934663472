#pragma once

#include <array>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/track/track_options.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"
#include "motion_state.h"

namespace fourwis
{

/// Where the robot will be when a command takes effect. The commands so far are remembered. The wheels are assumed to
/// follow them with a delay of `command_latency`. To this the last measured deviation is added, which decays with the
/// lag of the wheels.
class Forecast
{
public:
  /// Commands are remembered for this many control steps.
  static constexpr int kSteps = 124;

  Forecast(const Robot& robot, const TrackOptions& options);

  /// Forgets everything: the wheels of this mode rest at phi.
  void restart(Mode mode, double phi);

  /// From time t on, v and phi go to `next` over `duration` and stay there. Times must not decrease.
  void ask(double t, const ModeMotion& next, double duration);

  /// What was asked for at time t.
  ModeMotion asked(double t) const;

  /// What the wheels did at time t.
  void measured(double t, const ModeMotion& motion);

  /// The state at `until`, given where the robot was at `stamp`. v and phi are what was asked for: the controller does
  /// not see the noise of the wheels' encoders.
  MotionState ahead(const Pose& pose, double stamp, double until) const;

private:
  struct Knot
  {
    double t;
    ModeMotion motion;
  };
  ModeMotion expected(double t) const;

  static constexpr std::size_t kMemory = std::size_t{2} * (kSteps + 4);  ///< two knots for each, some for what is ahead

  Robot robot_;
  double drive_lag_, steering_lag_;
  Mode mode_ = Mode::none;
  std::array<Knot, kMemory> asked_;  ///< a ring, linear in between
  std::size_t newest_ = 0;
  Knot deviation_{};  ///< of what was measured from what was asked for
};

}  // namespace fourwis
