#pragma once

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/ocp/types.h"
#include "motion_limits.h"

namespace fourwis
{

/// No wheel turns faster than it can within an interval of constant d phi / dt = omega: two rows g <= 0.
///
/// The wheel at (x, y) = (+-L/2, +-W/2) stands at delta = atan2(.., ..) with, for c = gauge / base of the mode (W/L in
/// ackermann, L/W in lateral), d delta / d phi = 1 / (1 -+ c sin 2 phi + c^2 sin^2 phi). The greatest of them all is
/// therefore 1/D with
///   D(phi) = 1 - c |sin 2 phi| + c^2 sin^2 phi.
/// |s| is replaced by sqrt(s^2 + 0.05^2), which is smooth and no less, and D by its minimum beyond the |phi| where it has
/// one: then it is least where |phi| is greatest, at an end of the interval. With r the wheels' greatest rate the rows are
///   (omega / r)^2 - D(phi)^2 <= 0   and   (omega / r)^2 - D(phi + omega h)^2 <= 0.
/// In parallel motion c = 0: D = 1.
class WheelRateRows
{
public:
  static constexpr int kRows = 2;
  using Point = ocp::Vector<8>;  ///< (x, y, theta, v, phi, a, omega, h)

  WheelRateRows(const Robot& robot, Mode mode);

  void evaluate(const Point& q, double* values) const;

  /// Writes the gradients of the rows and adds sum_i y_i d2g_i/dq2 to `hessian`.
  template <class Multipliers, class Gradients>
  void differentiate(const Point& q, const Multipliers& y, Gradients& gradients, ocp::Matrix<8, 8>& hessian) const;

private:
  enum Index
  {
    kPhi = 4,
    kOmega = 6,
    kH = 7
  };

  /// -D^2 and its first two derivatives.
  struct Share
  {
    double value, slope, bend;
  };
  Share share(double phi) const;

  double ratio_;         ///< c
  double lowest_;        ///< the |phi| at which D is least [rad]
  double inverse_rate_;  ///< 1 / r
};

template <class Multipliers, class Gradients>
void WheelRateRows::differentiate(const Point& q, const Multipliers& y, Gradients& gradients,
                                  ocp::Matrix<8, 8>& hessian) const
{
  const double omega = q[kOmega], h = q[kH], scale = 2.0 * inverse_rate_ * inverse_rate_;
  const Share begin = share(q[kPhi]), end = share(q[kPhi] + omega * h);
  gradients(kPhi, 0) = begin.slope;
  gradients(kOmega, 0) = scale * omega;
  gradients(kPhi, 1) = end.slope;
  gradients(kOmega, 1) = scale * omega + h * end.slope;
  gradients(kH, 1) = omega * end.slope;

  hessian(kPhi, kPhi) += y[0] * begin.bend + y[1] * end.bend;
  hessian(kOmega, kOmega) += (y[0] + y[1]) * scale + y[1] * end.bend * h * h;
  hessian(kH, kH) += y[1] * end.bend * omega * omega;
  const auto add_pair = [&](int i, int j, double value) {
    hessian(i, j) += value;
    hessian(j, i) += value;
  };
  add_pair(kPhi, kOmega, y[1] * end.bend * h);
  add_pair(kPhi, kH, y[1] * end.bend * omega);
  add_pair(kOmega, kH, y[1] * (end.bend * omega * h + end.slope));
}

}  // namespace fourwis
