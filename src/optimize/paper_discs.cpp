#include "paper_discs.h"

#include <cmath>
#include <utility>

namespace fourwis
{
namespace
{

// The variables. Rows, like g, are in the order front x, front y, rear x, rear y.
constexpr int kX = 0, kY = 1, kTheta = 2, kT = 3, kG = 4;
constexpr int kCoordinates = 4;

}  // namespace

PaperDiscs::PaperDiscs(double offset, const PaperOptions& options, std::size_t steps, const Box& front, const Box& rear,
                       std::vector<int> the_variables)
  : NlpElement(std::move(the_variables), kCoordinates),
    offset_(offset),
    weight_(options.penalty),
    steps_(static_cast<double>(steps))
{
  row_lower << front.x_min, front.y_min, rear.x_min, rear.y_min;
  row_upper << front.x_max, front.y_max, rear.x_max, rear.y_max;
  jacobian_pattern.setConstant(false);
  hessian_pattern.setConstant(false);
  hessian_pattern(kTheta, kTheta) = true;
  for (int i = 0; i < kCoordinates; ++i)
  {
    for (int column : {i % 2 == 0 ? kX : kY, kTheta, kG + i}) jacobian_pattern(i, column) = true;
    hessian_pattern(kG + i, kG + i) = hessian_pattern(kG + i, kT) = hessian_pattern(kT, kG + i) = true;
  }
}

double PaperDiscs::evaluate(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> rows) const
{
  const double dx = offset_ * std::cos(x[kTheta]), dy = offset_ * std::sin(x[kTheta]);
  rows << x[kX] + dx, x[kY] + dy, x[kX] - dx, x[kY] - dy;
  rows += x.tail<kCoordinates>();
  return weight_ * x.tail<kCoordinates>().squaredNorm() * x[kT] / steps_;
}

void PaperDiscs::differentiate(const Eigen::VectorXd& x, double s, const Eigen::VectorXd& y, Derivatives& d) const
{
  const double dx = offset_ * std::cos(x[kTheta]), dy = offset_ * std::sin(x[kTheta]), h = x[kT] / steps_;
  const auto g = x.tail<kCoordinates>();
  d.jacobian.col(kX) << 1.0, 0.0, 1.0, 0.0;
  d.jacobian.col(kY) << 0.0, 1.0, 0.0, 1.0;
  d.jacobian.col(kTheta) << -dy, dx, dy, -dx;
  d.jacobian.rightCols<kCoordinates>().setIdentity();
  d.gradient[kT] = weight_ * g.squaredNorm() / steps_;
  d.gradient.tail<kCoordinates>() = 2.0 * weight_ * h * g;
  d.hessian(kTheta, kTheta) = dx * (y[2] - y[0]) + dy * (y[3] - y[1]);
  for (int i = 0; i < kCoordinates; ++i)
  {
    d.hessian(kG + i, kG + i) = 2.0 * s * weight_ * h;
    d.hessian(kG + i, kT) = d.hessian(kT, kG + i) = 2.0 * s * weight_ * g[i] / steps_;
  }
}

}  // namespace fourwis
