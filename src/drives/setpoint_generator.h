#pragma once

#include <cstdint>

#include "fourwis_navigation/drives/axis_motion.h"
#include "position_profile.h"

namespace fourwis::drives
{

/// The demands of a drive for its motor while power is on, by the mode of operation. Counts and s.
class SetpointGenerator
{
public:
  SetpointGenerator(const ObjectDictionary& dictionary, double max_velocity)
    : dictionary_(dictionary),
      max_velocity_(max_velocity),
      profile_(dictionary)
  {}

  /// Starts at the position of the motor: power is switched on, the mode changes or the counts are shifted. In the
  /// cyclic modes the target in the objects is followed from now on, even if it was written before.
  void start(const AxisMotion& measured);

  /// A new controlword has been written, for profile position.
  void command(std::uint16_t controlword, std::uint16_t previous) { profile_.command(controlword, previous); }
  /// A cyclic target position has been written.
  void target_written();

  /// One step in mode 6061.
  void follow(double dt);
  /// One step of braking instead.
  void brake(double deceleration, double dt);
  /// The braking has ended.
  bool at_rest() const { return setpoint_.velocity == 0.0; }

  AxisDemand demand() const;
  bool demands_position() const;
  /// Bits 10 to 13 of the statusword as far as they are about the set-point.
  std::uint16_t status(const AxisMotion& measured) const;

private:
  int mode() const { return static_cast<int>(dictionary_.get(object::kModeDisplay)); }
  void follow_cyclic_position(double dt);
  void follow_velocity(double velocity);

  const ObjectDictionary& dictionary_;
  double max_velocity_;
  Setpoint setpoint_;
  PositionProfile profile_;
  double time_left_ = 0.0;  ///< until the cyclic target position is reached
  bool limited_ = false;
};

}  // namespace fourwis::drives
