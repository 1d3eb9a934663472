#include "wheel_speed_rows.h"

#include <cmath>

#include "fourwis_navigation/vehicle/mode_traits.h"
#include "motion_limits.h"

namespace fourwis
{
namespace
{

/// Of a row's derivatives.
enum Index
{
  kV,
  kPhi,
  kA,
  kOmega,
  kH
};

}  // namespace

WheelSpeedRows::WheelSpeedRows(const Robot& robot, Mode mode)
  : gauge_(0.0),
    turns_(traits_of(mode).turns_with_phi()),
    inverse_max_(1.0 / MotionLimits::wheel_speed(robot))
{
  if (turns_) gauge_ = robot.*traits_of(mode).gauge / (robot.*traits_of(mode).base);
}

WheelSpeedRows::Ratio WheelSpeedRows::ratio(const Tangent& tangent, double side) const
{
  if (!turns_) return {inverse_max_, 0.0, 0.0};
  const double t = tangent.value, along = 1.0 + side * gauge_ * t;
  const double value = std::sqrt(along * along + t * t), by_t = (side * gauge_ * along + t) / value;
  const double by_t_twice = (gauge_ * gauge_ + 1.0 - by_t * by_t) / value;
  return {value * inverse_max_, by_t * tangent.slope * inverse_max_,
          (by_t_twice * tangent.slope * tangent.slope + by_t * tangent.bend) * inverse_max_};
}

void WheelSpeedRows::evaluate(const Point& q, double* values) const
{
  const double v0 = q[3], v1 = v0 + q[5] * q[7];
  const Tangent begin(q[4]), end(q[4] + q[6] * q[7]);
  for (double side : {1.0, -1.0})
  {
    const double begin_ratio = ratio(begin, side).value, end_ratio = ratio(end, side).value;
    const double at_begin = v0 * begin_ratio, between = (v0 * end_ratio + v1 * begin_ratio) / 2.0;
    *values++ = at_begin * at_begin - 1.0;
    *values++ = between * between - 1.0;
  }
}

/// f = v_0 R_0.
WheelSpeedRows::Row WheelSpeedRows::at_begin(const Point& q, const Ratio& begin)
{
  const double v0 = q[3];
  Row row{v0 * begin.value, ocp::Vector<5>::Zero(), ocp::Matrix<5, 5>::Zero()};
  row.gradient[kV] = begin.value;
  row.gradient[kPhi] = v0 * begin.slope;
  row.hessian(kV, kPhi) = row.hessian(kPhi, kV) = begin.slope;
  row.hessian(kPhi, kPhi) = v0 * begin.bend;
  return row;
}

/// f = (v_0 R_1 + v_1 R_0) / 2 with v_1 = v_0 + a h and R_1 at phi_1 = phi_0 + omega h.
WheelSpeedRows::Row WheelSpeedRows::between(const Point& q, const Ratio& begin, const Ratio& end)
{
  const double v0 = q[3], a = q[5], omega = q[6], h = q[7], v1 = v0 + a * h;
  Row row{(v0 * end.value + v1 * begin.value) / 2.0, {}, ocp::Matrix<5, 5>::Zero()};
  row.gradient << end.value + begin.value, v0 * end.slope + v1 * begin.slope, h * begin.value, v0 * end.slope * h,
      v0 * end.slope * omega + a * begin.value;
  row.gradient /= 2.0;
  ocp::Matrix<5, 5>& hessian = row.hessian;
  hessian(kPhi, kV) = end.slope + begin.slope;
  hessian(kPhi, kPhi) = v0 * end.bend + v1 * begin.bend;
  hessian(kA, kPhi) = h * begin.slope;
  hessian(kOmega, kV) = end.slope * h;
  hessian(kOmega, kPhi) = v0 * end.bend * h;
  hessian(kOmega, kOmega) = v0 * end.bend * h * h;
  hessian(kH, kV) = end.slope * omega;
  hessian(kH, kPhi) = v0 * end.bend * omega + a * begin.slope;
  hessian(kH, kA) = begin.value;
  hessian(kH, kOmega) = v0 * (end.bend * omega * h + end.slope);
  hessian(kH, kH) = v0 * end.bend * omega * omega;
  hessian /= 2.0;
  hessian.triangularView<Eigen::StrictlyUpper>() = hessian.transpose();
  return row;
}

}  // namespace fourwis
