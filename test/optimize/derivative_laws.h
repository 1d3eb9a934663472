#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>

#include "../support/random.h"
#include "optimize/nlp.h"

namespace fourwis
{

/// An element's derivatives at a point, and their differences.
class DerivativeCheck
{
public:
  DerivativeCheck(const NlpElement& element, Random& random, const Eigen::VectorXd& x)
    : element_(element),
      x_(x),
      y_(element.row_lower.size()),
      s_(random.between(-2.0, 2.0)),
      at_x_(derivatives(x))
  {
    for (double& value : y_) value = random.between(-1.0, 1.0);
    at_x_ = derivatives(x);
  }

  /// Gradient and Jacobian meet the differences of the values, the Hessian those of gradient and Jacobian, and nothing
  /// outside of the patterns differs from zero. `tolerance` is relative to the greatest entry.
  void expect_exact(double tolerance) const
  {
    for (Eigen::Index i = 0; i < x_.size(); ++i)
    {
      SCOPED_TRACE(testing::Message() << "variable " << i);
      const double step = 1e-6 * std::max(1.0, std::abs(x_[i]));
      const Eigen::VectorXd up = moved(i, step), down = moved(i, -step);
      const Eigen::VectorXd slope = (values(up) - values(down)) / (2.0 * step);
      expect_near(at_x_.gradient.segment(i, 1), slope.tail(1), tolerance, at_x_.gradient);
      expect_near(at_x_.jacobian.col(i), slope.head(slope.size() - 1), tolerance, at_x_.jacobian);
      expect_near(at_x_.hessian.col(i), (lagrangian_gradient(up) - lagrangian_gradient(down)) / (2.0 * step), tolerance,
                  at_x_.hessian);
    }
    expect_zero_outside(at_x_.jacobian, element_.jacobian_pattern);
    expect_zero_outside(at_x_.hessian, element_.hessian_pattern);
    EXPECT_EQ(at_x_.hessian, at_x_.hessian.transpose());
  }

private:
  NlpElement::Derivatives derivatives(const Eigen::VectorXd& x) const
  {
    const Eigen::Index n = x.size(), rows = y_.size();
    NlpElement::Derivatives d = {Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Zero(rows, n), Eigen::MatrixXd::Zero(n, n)};
    element_.differentiate(x, s_, y_, d);
    return d;
  }

  Eigen::VectorXd moved(Eigen::Index i, double step) const
  {
    Eigen::VectorXd x = x_;
    x[i] += step;
    return x;
  }

  /// The rows and the cost.
  Eigen::VectorXd values(const Eigen::VectorXd& x) const
  {
    Eigen::VectorXd result(y_.size() + 1);
    result[y_.size()] = element_.evaluate(x, result.head(y_.size()));
    return result;
  }

  Eigen::VectorXd lagrangian_gradient(const Eigen::VectorXd& x) const
  {
    const NlpElement::Derivatives d = derivatives(x);
    return s_ * d.gradient + d.jacobian.transpose() * y_;
  }

  static void expect_near(const Eigen::VectorXd& is, const Eigen::VectorXd& difference, double tolerance,
                          const Eigen::MatrixXd& all)
  {
    if (is.size() == 0) return;
    EXPECT_LE((is - difference).cwiseAbs().maxCoeff(), tolerance * std::max(1.0, all.cwiseAbs().maxCoeff()))
        << is.transpose() << "\ndifferences\n"
        << difference.transpose();
  }

  static void expect_zero_outside(const Eigen::MatrixXd& matrix, const NlpElement::Pattern& pattern)
  {
    EXPECT_TRUE((pattern || matrix.array() == 0.0).all()) << matrix;
  }

  const NlpElement& element_;
  const Eigen::VectorXd x_;
  Eigen::VectorXd y_;
  const double s_;
  NlpElement::Derivatives at_x_;
};

}  // namespace fourwis
