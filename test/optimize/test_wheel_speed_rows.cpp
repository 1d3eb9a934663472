#include "optimize/wheel_speed_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "derivative_laws.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 9;
constexpr int kRows = WheelSpeedRows::kRows;

/// Speed of the fastest wheel at an instant [m/s].
double fastest_wheel(const Robot& robot, Mode mode, double v, double phi)
{
  const double base = mode == Mode::lateral ? robot.track_width : robot.wheelbase;
  const double turn = mode == Mode::parallel ? 0.0 : 2.0 * std::tan(phi) / base;
  double fastest = 0.0;
  for (const WheelPosition& wheel : wheel_positions(robot))
  {
    // In lateral motion the body moves along y; for the speeds its sign does not matter.
    const double along = mode == Mode::lateral ? wheel.x : -wheel.y, across = mode == Mode::lateral ? wheel.y : wheel.x;
    fastest = std::max(fastest, std::abs(v) * std::hypot(1.0 + turn * along, turn * across));
  }
  return fastest;
}

struct WheelSpeeds : testing::Test
{
  /// An interval in which v and phi change linearly.
  static WheelSpeedRows::Point point(double v, double v_end, double phi, double phi_end, double h)
  {
    WheelSpeedRows::Point q = WheelSpeedRows::Point::Zero();
    q[3] = v;
    q[4] = phi;
    q[5] = (v_end - v) / h;
    q[6] = (phi_end - phi) / h;
    q[7] = h;
    return q;
  }

  /// Greatest of the rows; those of the end are the next interval's first.
  static double greatest_row(const Robot& robot, Mode mode, const WheelSpeedRows::Point& q)
  {
    double rows[2 * kRows];
    const WheelSpeedRows wheels(robot, mode);
    wheels.evaluate(q, rows);
    wheels.evaluate(point(q[3] + q[5] * q[7], q[3] + q[5] * q[7], q[4] + q[6] * q[7], q[4] + q[6] * q[7], 0.1),
                    rows + kRows);
    return *std::max_element(std::begin(rows), std::end(rows));
  }

  static double fastest_within(const Robot& robot, Mode mode, const WheelSpeedRows::Point& q)
  {
    double fastest = 0.0;
    for (int part = 0; part <= 200; ++part)
    {
      const double t = part / 200.0 * q[7];
      fastest = std::max(fastest, fastest_wheel(robot, mode, q[3] + q[5] * t, q[4] + q[6] * t));
    }
    return fastest;
  }

  /// Random robots, modes and intervals; phi changes by `change` at most.
  template <typename Visit>
  void for_intervals(double change, Visit visit)
  {
    for (int trial = 0; trial < 4000; ++trial)
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
      Robot robot;
      robot.wheelbase = random.between(0.2, 1.0);
      robot.track_width = random.between(0.2, 0.6);
      robot.wheel_max_speed = random.between(0.5, 4.0);
      const Mode mode = random.mode();
      const double phi = random.between(-1.3, 1.3), phi_end = std::clamp(phi + random.unit() * change, -1.3, 1.3);
      // Never through standstill: a segment's cusps are its knots.
      const double side = random.chance(0.5) ? 1.0 : -1.0;
      visit(robot, mode,
            point(side * random.between(0.0, 2.0), side * random.between(0.0, 2.0), phi, phi_end,
                  random.between(0.05, 0.5)));
    }
  }

  Random random{kSeed};
};

TEST_F(WheelSpeeds, WhereTheRowsHoldNoWheelIsTooFastAllAlongTheInterval)
{
  int held = 0, close = 0;
  for_intervals(0.6, [&](const Robot& robot, Mode mode, const WheelSpeedRows::Point& q) {
    if (greatest_row(robot, mode, q) > 0.0) return;
    ++held;
    const double fastest = fastest_within(robot, mode, q);
    EXPECT_LE(fastest, robot.wheel_max_speed);
    close += fastest > 0.9 * robot.wheel_max_speed;
  });
  EXPECT_GT(held, 1000);
  EXPECT_GT(close, 50);
}

TEST_F(WheelSpeeds, TheRowsForbidHardlyMoreThanTheyMust)
{
  int broken = 0;
  for_intervals(0.2, [&](const Robot& robot, Mode mode, const WheelSpeedRows::Point& q) {
    if (greatest_row(robot, mode, q) <= 0.0) return;
    ++broken;
    EXPECT_GE(fastest_within(robot, mode, q), 0.95 * robot.wheel_max_speed);
  });
  EXPECT_GT(broken, 1000);
}

TEST_F(WheelSpeeds, AtAConstantAngleTheRowsAreExact)
{
  for_intervals(0.0, [&](const Robot& robot, Mode mode, const WheelSpeedRows::Point& q) {
    // A thousandth is kept for rounding.
    const double share = fastest_within(robot, mode, q) / (0.999 * robot.wheel_max_speed);
    EXPECT_NEAR(greatest_row(robot, mode, q), share * share - 1.0, 1e-9 * (1.0 + share * share));
  });
}

/// The rows as an element of a nonlinear program.
struct RowsElement : NlpElement
{
  RowsElement(const Robot& robot, Mode mode) : NlpElement({0, 1, 2, 3, 4, 5, 6, 7}, kRows), wheels(robot, mode) {}

  double evaluate(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> rows) const override
  {
    double values[kRows];
    wheels.evaluate(x, values);
    for (int i = 0; i < kRows; ++i) rows[i] = values[i];
    return 0.0;
  }

  void differentiate(const Eigen::VectorXd& x, double, const Eigen::VectorXd& y, Derivatives& d) const override
  {
    Eigen::Matrix<double, 8, kRows> gradients = Eigen::Matrix<double, 8, kRows>::Zero();
    WheelSpeedRows::Hessian hessian = WheelSpeedRows::Hessian::Zero();
    wheels.differentiate(x, y.data(), 0, gradients, hessian);
    d.jacobian = gradients.transpose();
    d.hessian = hessian;
  }

  const WheelSpeedRows wheels;
};

TEST_F(WheelSpeeds, DerivativesMeetDifferences)
{
  for (int trial = 0; trial < 300; ++trial)
  {
    Robot robot;
    robot.wheelbase = random.between(0.2, 1.0);
    robot.track_width = random.between(0.2, 0.6);
    const RowsElement element(robot, random.mode());
    Eigen::VectorXd x(8);
    for (Eigen::Index i = 0; i < 8; ++i) x[i] = random.unit();
    x[7] = random.between(0.05, 0.5);
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", trial " << trial);
    DerivativeCheck(element, random, x).expect_exact(1e-7);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace fourwis
