#pragma once

#include <array>
#include <random>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/sim/simulator_options.h"

namespace fourwis
{

/// The measurement of four wheels: noise is added first, then the value is rounded to steps. Repeatable: a frozen wheel
/// takes random numbers, too.
class Encoders
{
public:
  /// Throws as check() does.
  Encoders(const EncoderOptions& options, int seed);

  void measure(const WheelMotion& truth);
  const WheelMotion& measured() const { return measured_; }

  /// The measurement of a wheel does not change any more.
  void freeze(int wheel) { frozen_[static_cast<std::size_t>(wheel)] = true; }
  void release_all() { frozen_ = {}; }

private:
  double reading(double truth, double resolution, double deviation);

  EncoderOptions options_;
  std::mt19937_64 engine_;
  std::normal_distribution<double> noise_;
  std::array<bool, kWheels> frozen_{};
  WheelMotion measured_;
};

}  // namespace fourwis
