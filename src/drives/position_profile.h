#pragma once

#include <cstdint>
#include <optional>

#include "drive_objects.h"

namespace fourwis::drives
{

/// Value nearer to `target` by at most `step`.
double approach(double value, double target, double step);

/// A position and its speed that change as a drive wants its motor to. Counts and s.
struct Setpoint
{
  double position = 0.0, velocity = 0.0;

  void brake(double deceleration, double dt)
  {
    velocity = approach(velocity, 0.0, deceleration * dt);
    position += velocity * dt;
  }
};

/// Profile position mode: set-points handed over with bit 4 of the controlword, and a trapezoid towards them.
class PositionProfile
{
public:
  explicit PositionProfile(const ObjectDictionary& dictionary) : dictionary_(dictionary) {}

  /// Forgets what it was about; stays where it is.
  void reset(double position);

  /// Bit 4 rising hands over a set-point, bit 5 at once instead of after the one before, bit 6 relative.
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
  bool handed_over_ = false;    ///< bit 4 as it stands
  bool acknowledge_ = false, reached_ = false, limited_ = false;
};

}  // namespace fourwis::drives
