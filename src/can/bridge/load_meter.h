#pragma once

namespace fourwis::can
{

/// The load of the bus by all frames that were sent or received, over the last full second.
class LoadMeter
{
public:
  explicit LoadMeter(double bit_rate) : bit_rate_(bit_rate) {}

  void add(double bits) { bits_ += bits; }

  /// To be called at least once a second.
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
