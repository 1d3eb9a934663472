#pragma once

#include <cmath>

#include "fourwis_navigation/ocp/solver.h"

namespace fourwis::ocp
{

/// x = (p, v), u = (a, h): a mass on a rail, in the least time.
struct Shuttle : ModelBase<2, 2>
{
  void evaluate(std::size_t, const State& x, const Control& u, const State& next, Value& value) const
  {
    value.cost = u[1];
    value.defect << x[0] + u[1] * x[1] + 0.5 * u[0] * u[1] * u[1] - next[0], x[1] + u[0] * u[1] - next[1];
  }

  void differentiate(std::size_t, const State& x, const Control& u, const State& lambda, Derivatives& d) const
  {
    const double a = u[0], h = u[1];
    d.jacobian << 1, h, 0.5 * h * h, x[1] + a * h,  //
        0, 1, h, a;
    d.gradient[3] = 1;
    d.hessian(1, 3) = d.hessian(3, 1) = lambda[0];
    d.hessian(2, 3) = d.hessian(3, 2) = lambda[0] * h + lambda[1];
    d.hessian(3, 3) = lambda[0] * a;
  }

  /// By `distance` from rest to rest with |a| <= `acceleration`.
  static Problem<2, 2> problem(double distance, double acceleration, std::size_t intervals)
  {
    Problem<2, 2> problem;
    problem.reset(intervals);
    problem.terminal_state << distance, 0;
    problem.terminal_fixed = {true, true};
    for (auto& bounds : problem.bounds)
    {
      bounds.lower.tail<2>() << -acceleration, 1e-3;
      bounds.upper.tail<2>() << acceleration, 1.0;
    }
    return problem;
  }

  static Trajectory<2, 2> guess(double distance, std::size_t intervals)
  {
    Trajectory<2, 2> guess;
    for (std::size_t k = 0; k <= intervals; ++k)
      guess.states.push_back({distance * static_cast<double>(k) / static_cast<double>(intervals), 0.5});
    guess.controls.assign(intervals, {0.0, 0.1});
    return guess;
  }
};

/// x = (x, y, theta, v), u = (a, kappa, h): a car that is to keep a point ahead of it in half-planes,
/// l = h + 1/2 kappa^2 h and nx (x + ahead cos theta) + ny (y + ahead sin theta) <= c.
struct Car : ModelBase<4, 3, 3>
{
  struct HalfPlane
  {
    double nx, ny;
  };
  double ahead = 0.4;
  std::vector<HalfPlane> half_planes;  ///< the rows of each stage between the first and the last

  void evaluate(std::size_t, const State& x, const Control& u, const State& next, Value& value) const
  {
    const double s = u[2] * x[3];
    value.cost = u[2] * (1.0 + 0.5 * u[1] * u[1]);
    value.defect << x[0] + s * std::cos(x[2]), x[1] + s * std::sin(x[2]), x[2] + s * u[1], x[3] + u[2] * u[0];
    value.defect -= next;
  }

  void differentiate(std::size_t, const State& x, const Control& u, const State& lambda, Derivatives& d) const
  {
    const double v = x[3], a = u[0], kappa = u[1], h = u[2], c = std::cos(x[2]), s = std::sin(x[2]);
    d.jacobian << 1, 0, -h * v * s, h * c, 0, 0, v * c,  //
        0, 1, h * v * c, h * s, 0, 0, v * s,             //
        0, 0, 1, h * kappa, 0, h * v, v * kappa,         //
        0, 0, 0, 1, h, 0, a;
    d.gradient[5] = h * kappa;
    d.gradient[6] = 1 + 0.5 * kappa * kappa;
    const double along = lambda[0] * c + lambda[1] * s, across = lambda[1] * c - lambda[0] * s;
    d.hessian(2, 2) = -h * v * along;
    d.hessian(2, 3) = h * across;
    d.hessian(2, 6) = v * across;
    d.hessian(3, 5) = h * lambda[2];
    d.hessian(3, 6) = along + kappa * lambda[2];
    d.hessian(4, 6) = lambda[3];
    d.hessian(5, 5) = h;
    d.hessian(5, 6) = kappa + v * lambda[2];
    d.hessian.triangularView<Eigen::StrictlyLower>() = d.hessian.transpose();
  }

  void rows(std::size_t, const RowPoint& q, RowValues values) const
  {
    const double x = q[0] + ahead * std::cos(q[2]), y = q[1] + ahead * std::sin(q[2]);
    for (Eigen::Index i = 0; i < values.size(); ++i)
    {
      const auto [nx, ny] = half_planes[static_cast<std::size_t>(i)];
      values[i] = nx * x + ny * y;
    }
  }

  void differentiate_rows(std::size_t, const RowPoint& q, RowMultipliers y, Gradients gradients,
                          RowHessian& hessian) const
  {
    const double dx = -ahead * std::sin(q[2]), dy = ahead * std::cos(q[2]);
    for (Eigen::Index i = 0; i < y.size(); ++i)
    {
      const auto [nx, ny] = half_planes[static_cast<std::size_t>(i)];
      gradients.col(i) << nx, ny, nx * dx + ny * dy;
      hessian(2, 2) += y[i] * (ny * dx - nx * dy);
    }
  }

  /// A swing to the left by 1 m between two walls that leave it late and end it early: |y| <= 0.15 in the first 2/5 of
  /// the intervals, |y - 1| <= 0.15 in the last 2/5 (y of the point ahead).
  static Problem<4, 3> swing(Car& car, std::size_t intervals, double weight)
  {
    car.half_planes = {{0.0, 1.0}, {0.0, -1.0}};
    Problem<4, 3> problem;
    problem.reset(intervals);
    problem.terminal_state << 3.0, 1.0, 0.0, 0.0;
    problem.terminal_fixed = {true, true, true, true};
    for (std::size_t k = 0; k <= intervals; ++k)
    {
      problem.bounds[k].lower.tail<4>() << 0.0, -2.0, -3.0, 0.08;
      problem.bounds[k].upper.tail<4>() << 1.0, 2.0, 3.0, 0.12;
      if (k == 0 || k == intervals) continue;
      problem.add_row(k, {5 * k <= 2 * intervals ? 0.15 : 1.15, weight});
      problem.add_row(k, {5 * k < 3 * intervals ? 0.15 : -0.85, weight});
    }
    return problem;
  }

  static Trajectory<4, 3> guess(std::size_t intervals)
  {
    Trajectory<4, 3> guess;
    for (std::size_t k = 0; k <= intervals; ++k)
    {
      const double share = static_cast<double>(k) / static_cast<double>(intervals);
      guess.states.push_back({3.0 * share, share, 0.3, 0.8});
    }
    guess.controls.assign(intervals, {0.0, 0.0, 4.0 / static_cast<double>(intervals)});
    return guess;
  }
};

}  // namespace fourwis::ocp
