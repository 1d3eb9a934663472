#pragma once

#include <cstdint>
#include <optional>

#include "drive_objects.h"

namespace fourwis::drives
{

/// `value`, moved towards `target` by at most `step`.
double approach(double value, double target, double step);

/// The position and velocity that a drive demands of its motor. Counts and s.
struct Setpoint
{
  double position = 0.0, velocity = 0.0;

  void brake(double deceleration, double dt)
  {
    velocity = approach(velocity, 0.0, deceleration * dt);
    position += velocity * dt;
  }
};

/// Profile position mode: set-points are handed over with bit 4 of the controlword and reached with a trapezoidal
/// profile.
class PositionProfile
{
public:
  explicit PositionProfile(const ObjectDictionary& dictionary) : dictionary_(dictionary) {}

  /// Drops all set-points. The position stays.
  void reset(double position);

  /// A rising bit 4 hands over a set-point. Bit 5: it replaces the present one at once; bit 6: it is relative.
  void command(std::uint16_t controlword, std::uint16_t previous);

  /// One step towards the target, within `low`..`high`.
  void follow(Setpoint& setpoint, double low, double high, double dt);

  bool reached() const { return reached_; }
  bool acknowledges() const { return acknowledge_; }  ///< bit 12 of the statusword
  bool is_limited() const { return limited_; }        ///< the target lies beyond a limit

private:
  void take(double target);

  const ObjectDictionary& dictionary_;
  double target_ = 0.0;
  std::optional<double> next_;  ///< waits until the target is reached
  bool handed_over_ = false;    ///< the present bit 4
  bool acknowledge_ = false, reached_ = false, limited_ = false;
};

}  // namespace fourwis::drives
