#include "fourwis_navigation/sim/encoders.h"

#include <cmath>

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{

Encoders::Encoders(const EncoderOptions& options, int seed)
  : options_(checked(options)),
    engine_(static_cast<std::mt19937_64::result_type>(seed))
{}

void Encoders::measure(const WheelMotion& truth)
{
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const double angle = reading(truth.angle[i], options_.angle_resolution, options_.angle_noise);
    const double speed = reading(truth.speed[i], options_.speed_resolution, options_.speed_noise);
    if (frozen_[i]) continue;
    measured_.angle[i] = angle;
    measured_.speed[i] = speed;
  }
}

double Encoders::reading(double truth, double resolution, double deviation)
{
  const double noisy = truth + deviation * noise_(engine_);
  return resolution > 0.0 ? std::round(noisy / resolution) * resolution : noisy;
}

}  // namespace fourwis
