#pragma once

#include <array>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::referee
{

/// Equivalent steering angles from low to high [rad].
struct PhiRange
{
  double low, high;
};

/// One wheel in one mode. C is the centre of the wheels. With t = tan(phi) and C moving at unit speed, the wheel moves
/// at 1 + q t along the direction it has at phi = 0 and at p t to the left of that. In parallel mode all wheels turn
/// with phi itself.
class WheelMotion
{
public:
  WheelMotion() = default;
  WheelMotion(const Robot& robot, Mode mode, int wheel);

  /// Steering angle, continuous in phi for |phi| < pi/2 and monotonic [rad].
  double angle(double phi) const;

  /// Greatest |d angle / d phi| over a range of phi.
  double greatest_gain(PhiRange range) const;

  /// Rolling speed per unit speed of C; convex in tan(phi), so that no phi between two others gives more than both.
  double speed_factor(double phi) const;

private:
  bool parallel_ = false;
  double base_ = 0.0;  ///< angle at phi = 0 [rad]
  double p_ = 0.0, q_ = 0.0;
};

/// The four wheels of a robot in the planned modes. rules.cpp rejects the others; here they have zeros.
class Wheels
{
public:
  explicit Wheels(const Robot& robot);

  const WheelMotion& motion(Mode mode, int wheel) const;

  /// Greatest speed factor and gain of any wheel of a mode within the limit of the steering angle.
  double greatest_speed_factor(Mode mode) const { return greatest_speed_factor_[index_of(mode)]; }
  double greatest_gain(Mode mode) const { return greatest_gain_[index_of(mode)]; }

  /// Whether some branch (angle + k pi) of the wheel's angle stays within its travel for all phi of the range.
  bool has_branch(Mode mode, int wheel, PhiRange range) const;

  /// Least turn of the wheel at rest between angles that give the two motions, both within its travel; infinite when
  /// one of them has none [rad].
  double least_turn(int wheel, Mode from, double phi_from, Mode to, double phi_to) const;

private:
  double max_angle_;
  std::array<std::array<WheelMotion, kWheels>, kModeCount> motions_;  ///< by mode number
  std::array<double, kModeCount> greatest_speed_factor_{}, greatest_gain_{};
};

}  // namespace fourwis::referee
