#pragma once

namespace fourwis::can
{

/// How busy the bus is with what we see of it, over the last full second.
class LoadMeter
{
public:
  explicit LoadMeter(double bit_rate) : bit_rate_(bit_rate) {}

  void add(double bits) { bits_ += bits; }

  /// Now and then, at least every second.
  void update(double now)
  {
    const double elapsed = now - begun_;
    if (elapsed < 1.0) return;
    load_ = bits_ / (bit_rate_ * elapsed);
    bits_ = 0.0;
    begun_ = now;
  }

  double load() const { return load_; }  ///< 0 to 1

private:
  double bit_rate_;
  double begun_ = 0.0, bits_ = 0.0, load_ = 0.0;
};

}  // namespace fourwis::can
