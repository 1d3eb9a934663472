#pragma once

#include <cmath>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/ocp/types.h"

namespace fourwis
{

/// No wheel rolls faster than it can within an interval of constant a and omega: four rows g <= 0.
///
/// The fastest wheels are those on the outside of the curve. With t = tan phi and c = gauge / base of the mode (W/L in
/// ackermann, L/W in lateral) a wheel of that side rolls
///   R(phi) = sqrt((1 + c t)^2 + t^2)
/// times as fast as C, one of the other side R(-phi) times. v and phi are linear in time within the interval. Where R is
/// convex, v R lies below the Bezier curve of second order with the control points
///   v_0 R_0,   (v_0 R_1 + v_1 R_0) / 2,   v_1 R_1,
/// 0 and 1 being the ends of the interval. The last is the first of the next interval, so that for both sides and with w the
/// greatest speed of a wheel the rows are
///   (v_0 R_0 / w)^2 - 1 <= 0   and   ((v_0 R_1 + v_1 R_0) / 2 w)^2 - 1 <= 0.
class WheelSpeedRows
{
public:
  static constexpr int kRows = 4;
  using Point = ocp::Vector<8>;  ///< (x, y, theta, v, phi, a, omega, h)
  using Hessian = ocp::Matrix<8, 8>;

  WheelSpeedRows(const Robot& robot, Mode mode);

  void evaluate(const Point& q, double* values) const;

  /// Writes the gradients of the rows, from column `first` on, and adds sum_i y_i d2g_i/dq2 to `hessian`; y begins at the rows.
  template <class Gradients>
  void differentiate(const Point& q, const double* y, int first, Gradients& gradients, Hessian& hessian) const
  {
    const Tangent begin(q[4]), end(q[4] + q[6] * q[7]);
    for (int k = 0; k < 2; ++k)
    {
      const double side = k == 0 ? 1.0 : -1.0;
      const Ratio begin_ratio = ratio(begin, side), end_ratio = ratio(end, side);
      const Row rows[] = {at_begin(q, begin_ratio), between(q, begin_ratio, end_ratio)};
      for (const Row& row : rows)
      {
        gradients.col(first).template tail<5>() = 2.0 * row.value * row.gradient;
        hessian.template bottomRightCorner<5, 5>() +=
            (2.0 * *y) * (row.value * row.hessian + row.gradient * row.gradient.transpose());
        ++first;
        ++y;
      }
    }
  }

private:
  /// tan phi and its first two derivatives.
  struct Tangent
  {
    explicit Tangent(double phi) : value(std::tan(phi)), slope(1.0 + value * value), bend(2.0 * value * slope) {}
    double value, slope, bend;
  };

  /// R/w and its first two derivatives.
  struct Ratio
  {
    double value, slope, bend;
  };

  /// f in g = f^2 - 1 with its derivatives with respect to (v, phi, a, omega, h).
  struct Row
  {
    double value;
    ocp::Vector<5> gradient;
    ocp::Matrix<5, 5> hessian;
  };

  Ratio ratio(const Tangent& tangent, double side) const;
  static Row at_begin(const Point& q, const Ratio& begin);
  static Row between(const Point& q, const Ratio& begin, const Ratio& end);

  double gauge_;  ///< c; 0 where phi does not turn the body, and then R = 1
  bool turns_;
  double inverse_max_;  ///< 1 / w
};

/// In the place of the rows where no wheel rolls too fast at any phi, which saves a fifth of the time.
struct NoWheelSpeedRows
{
  static constexpr int kRows = 0;

  NoWheelSpeedRows(const Robot&, Mode) {}

  template <class Point>
  void evaluate(const Point&, const double*) const
  {}

  template <class Point, class Gradients, class Hessian>
  void differentiate(const Point&, const double*, int, const Gradients&, const Hessian&) const
  {}
};

}  // namespace fourwis
