#include "wheels.h"

#include <algorithm>
#include <cmath>

namespace fourwis::referee
{
namespace
{

constexpr double kTravelRounding = 1e-6;  // [rad]

}  // namespace

// A turning rate kappa v moves a wheel at (x, y) by (-kappa y, kappa x) v beside the motion of C, the centre of the
// wheels. Ackermann: C moves along x, kappa = 2 t / L. Lateral: C moves along y, whose left is -x, and kappa = 2 t / W.
WheelMotion::WheelMotion(const Robot& robot, Mode mode, int wheel)
{
  const WheelPosition at = wheel_positions(robot)[static_cast<std::size_t>(wheel)];
  switch (mode)
  {
    case Mode::ackermann:
      p_ = 2.0 * at.x / robot.wheelbase;
      q_ = -2.0 * at.y / robot.wheelbase;
      break;
    case Mode::lateral:
      base_ = M_PI_2;
      p_ = 2.0 * at.y / robot.track_width;
      q_ = 2.0 * at.x / robot.track_width;
      break;
    default: parallel_ = true;
  }
}

double WheelMotion::angle(double phi) const
{
  if (parallel_) return phi;
  const double t = std::tan(phi);
  return base_ + std::atan2(p_ * t, 1.0 + q_ * t);
}

// d angle / d phi = p / D, D = (cos + q sin)^2 + (p sin)^2 = (1 + q^2 + p^2) / 2 + (1 - q^2 - p^2) / 2 cos 2 phi
// + q sin 2 phi: a wave in 2 phi, least at its trough when the range has one, else at an end of the range.
double WheelMotion::greatest_gain(PhiRange range) const
{
  if (parallel_) return 1.0;
  const double mean = (1.0 + q_ * q_ + p_ * p_) / 2.0, cosine = (1.0 - q_ * q_ - p_ * p_) / 2.0;
  const auto wave = [&](double phi) { return mean + cosine * std::cos(2.0 * phi) + q_ * std::sin(2.0 * phi); };
  const double trough = (std::atan2(q_, cosine) + M_PI) / 2.0;
  const double first_trough = trough + std::ceil((range.low - trough) / M_PI) * M_PI;
  const double least = first_trough <= range.high ? wave(first_trough) : std::min(wave(range.low), wave(range.high));
  return std::abs(p_) / least;
}

double WheelMotion::speed_factor(double phi) const
{
  if (parallel_) return 1.0;
  const double t = std::tan(phi);
  return std::hypot(1.0 + q_ * t, p_ * t);
}

Wheels::Wheels(const Robot& robot) : max_angle_(robot.wheel_max_angle * (1.0 + kTravelRounding))
{
  const PhiRange range{-robot.max_steering_angle, robot.max_steering_angle};
  for (Mode mode : kPlannedModes)
  {
    const std::size_t m = index_of(mode);
    for (int wheel = 0; wheel < kWheels; ++wheel)
    {
      WheelMotion& motion = motions_[m][static_cast<std::size_t>(wheel)];
      motion = WheelMotion(robot, mode, wheel);
      for (const double phi : {range.low, range.high})
        greatest_speed_factor_[m] = std::max(greatest_speed_factor_[m], motion.speed_factor(phi));
      greatest_gain_[m] = std::max(greatest_gain_[m], motion.greatest_gain(range));
    }
  }
}

const WheelMotion& Wheels::motion(Mode mode, int wheel) const
{
  return motions_[index_of(mode)][static_cast<std::size_t>(wheel)];
}

bool Wheels::has_branch(Mode mode, int wheel, PhiRange range) const
{
  const double one = motion(mode, wheel).angle(range.low), other = motion(mode, wheel).angle(range.high);
  const double low = std::min(one, other), high = std::max(one, other);
  const double lowest_branch = low + std::ceil((-max_angle_ - low) / M_PI) * M_PI;
  return lowest_branch + (high - low) <= max_angle_;
}

double Wheels::least_turn(int wheel, Mode from, double phi_from, Mode to, double phi_to) const
{
  const double angle_from = motion(from, wheel).angle(phi_from), angle_to = motion(to, wheel).angle(phi_to);
  const auto lowest = [&](double angle) { return angle + std::ceil((-max_angle_ - angle) / M_PI) * M_PI; };
  double least = INFINITY;
  for (double a = lowest(angle_from); a <= max_angle_; a += M_PI)
    for (double b = lowest(angle_to); b <= max_angle_; b += M_PI) least = std::min(least, std::abs(b - a));
  return least;
}

}  // namespace fourwis::referee
