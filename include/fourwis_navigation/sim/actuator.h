#pragma once

namespace fourwis
{

/// A value (angle or speed) that follows its target with a first-order lag, at a limited rate, within a range about 0.
class Actuator
{
public:
  struct Limits
  {
    double range;  ///< greatest |value|
    double rate;   ///< greatest |change| per second
    double lag;    ///< time constant [s]; 0: only the rate limits
  };

  explicit Actuator(const Limits& limits) : limits_(limits) {}

  void set_target(double target) { target_ = target; }
  double target() const { return target_; }

  /// Sets the value, for an axis that something else moves. The target stays.
  void set_value(double value);

  /// Advances the time by `duration` [s] with a constant target. Exact for any duration, unless the rate limits.
  void step(double duration);

  double value() const { return value_; }

private:
  Limits limits_;
  double target_ = 0.0, value_ = 0.0;
};

}  // namespace fourwis
