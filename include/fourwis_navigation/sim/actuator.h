#pragma once

namespace fourwis
{

/// A value (angle or speed) that follows its target: first-order lag, limited rate, within a range about 0.
class Actuator
{
public:
  struct Limits
  {
    double range;  ///< greatest |value|
    double rate;   ///< greatest |change| for each second
    double lag;    ///< time constant [s]; 0: only the rate limits
  };

  explicit Actuator(const Limits& limits) : limits_(limits) {}

  void set_target(double target) { target_ = target; }
  double target() const { return target_; }

  /// Forces the value to where something else has moved it; the target stays.
  void set_value(double value);

  /// Lets time pass [s]; the target stays what it is meanwhile. Exact for any duration that the rate does not limit.
  void step(double duration);

  double value() const { return value_; }

private:
  Limits limits_;
  double target_ = 0.0, value_ = 0.0;
};

}  // namespace fourwis
