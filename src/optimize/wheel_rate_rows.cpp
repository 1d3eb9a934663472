#include "wheel_rate_rows.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/mode_traits.h"

namespace fourwis
{
namespace
{

/// Smooths the corner of |sin 2 phi|.
constexpr double kRounding = 0.05;

double ratio(const Robot& robot, Mode mode)
{
  const ModeTraits& traits = traits_of(mode);
  return traits.turns_with_phi() ? robot.*traits.gauge / (robot.*traits.base) : 0.0;
}

/// Where dD/dphi = 0: cos^2 2 phi = c^2 (1 + rounding^2) / (4 + c^2).
double lowest(double c)
{
  return std::acos(std::min(1.0, c * std::sqrt((1.0 + kRounding * kRounding) / (4.0 + c * c)))) / 2.0;
}

}  // namespace

WheelRateRows::WheelRateRows(const Robot& robot, Mode mode)
  : ratio_(ratio(robot, mode)),
    lowest_(lowest(ratio_)),
    inverse_rate_(1.0 / MotionLimits::wheel_rate(robot))
{}

WheelRateRows::Share WheelRateRows::share(double phi) const
{
  if (std::abs(phi) > lowest_) return {share(lowest_).value, 0.0, 0.0};
  const double c = ratio_, sine = std::sin(2.0 * phi), cosine = std::cos(2.0 * phi);
  const double size = std::sqrt(sine * sine + kRounding * kRounding);  // of the sine
  const double size_slope = 2.0 * sine * cosine / size;
  const double size_bend = (4.0 * (cosine * cosine - sine * sine) - size_slope * size_slope) / size;
  const double d = 1.0 - c * size + c * c * (1.0 - cosine) / 2.0;
  const double d_slope = -c * size_slope + c * c * sine, d_bend = -c * size_bend + 2.0 * c * c * cosine;
  return {-d * d, -2.0 * d * d_slope, -2.0 * (d_slope * d_slope + d * d_bend)};
}

void WheelRateRows::evaluate(const Point& q, double* values) const
{
  const double turned = q[kOmega] * inverse_rate_;
  values[0] = turned * turned + share(q[kPhi]).value;
  values[1] = turned * turned + share(q[kPhi] + q[kOmega] * q[kH]).value;
}

}  // namespace fourwis
