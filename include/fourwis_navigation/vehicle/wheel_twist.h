#pragma once

#include <array>

#include <Eigen/Core>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{

/// How much the measured wheels are trusted.
struct WheelTwistOptions
{
  double deviation = 0.01;     ///< standard deviation of a wheel's velocity, along and across its heading [m/s]
  double greatest_slip = 0.1;  ///< residual beyond which the wheel that fits least is left out [m/s]
  double axis_offset = 0.0;    ///< from the steering axis to the wheel, to the left of its heading [m]

  /// The table of the options but `axis_offset`; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("deviation", o.deviation, 0.0, 10.0, "m/s");
    row("greatest_slip", o.greatest_slip, 0.0, 1e3, "m/s");
  }
};

/// Throws std::invalid_argument naming key, value and range: of `axis_offset`, a quarter of the robot's wheelbase or track.
void check(const Robot& robot, const WheelTwistOptions& options);

/// A body's twist and how well it explains the wheels.
struct TwistEstimate
{
  Twist twist;
  double residual = 0.0;  ///< slip: sqrt(r'r / (equations - 3)) of the velocities r that the twist leaves over [m/s]
  int left_out = -1;      ///< the wheel that was not used, or -1
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (vx, vy, omega)
};

/// Body twist from four wheels in any mode, spin and lateral included: least squares over
///   vx - omega y = s cos(a),   vy + omega x = s sin(a)
/// of every wheel at (x, y) with angle a and speed s. The normal matrix J'J depends on the positions alone, for all
/// four wheels and for each three of them. Covariance: (J'J)^-1 times the square of the deviation or, if greater, the
/// residual.
class WheelTwist
{
public:
  /// Throws as check() does.
  WheelTwist(const Robot& robot, const WheelTwistOptions& options);

  /// `steering_rate` of the wheels [rad/s] matters only with an offset: a wheel beside its axis rolls as it is steered,
  /// by offset * (omega + steering rate) less than its axis moves.
  TwistEstimate estimate(const WheelMotion& wheels, const PerWheel& steering_rate = {}) const;

private:
  /// Velocities of the steering axes in the body's frame: a column for each wheel.
  using AxisVelocities = Eigen::Matrix<double, 2, kWheels>;

  AxisVelocities axis_velocities(const WheelMotion& wheels, const PerWheel& steering_rate, double omega) const;
  TwistEstimate robust(const AxisVelocities& measured) const;
  TwistEstimate solve(const AxisVelocities& measured, int left_out) const;

  WheelTwistOptions options_;
  std::array<WheelPosition, kWheels> axes_;
  std::array<Eigen::Matrix3d, kWheels + 1> inverse_;  ///< (J'J)^-1 without wheel i; the last one of all wheels
};

}  // namespace fourwis
