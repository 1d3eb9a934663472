#pragma once

#include <limits>

namespace fourwis::can
{

/// Whether a condition has been true without interruption for some time.
class Steady
{
public:
  explicit Steady(double duration) : duration_(duration) {}

  /// To be called with each evaluation of the condition; the result includes it.
  bool update(bool condition, double now)
  {
    if (!condition)
      reset();
    else if (since_ == kNever)
      since_ = now;
    return holds(now);
  }
  // A nanosecond of slack, because times are sums of cycles.
  bool holds(double now) const { return now - since_ >= duration_ - 1e-9; }
  void reset() { since_ = kNever; }

private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  double duration_;
  double since_ = kNever;
};

}  // namespace fourwis::can
