#include "fourwis_navigation/sim/encoders.h"

#include <cmath>

#include "fourwis_navigation/model/option_range.h"

namespace fourwis
{

Encoders::Encoders(const EncoderOptions& options, int seed)
  : options_(options),
    engine_(static_cast<std::mt19937_64::result_type>(seed))
{
  require_between("angle_resolution", options.angle_resolution, 0.0, 0.1);
  require_between("angle_noise", options.angle_noise, 0.0, 0.1);
  require_between("speed_resolution", options.speed_resolution, 0.0, 0.1);
  require_between("speed_noise", options.speed_noise, 0.0, 0.1);
}

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
