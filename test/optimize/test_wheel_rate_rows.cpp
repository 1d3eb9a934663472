#include "optimize/wheel_rate_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/random.h"
#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 8;

/// Greatest rate of any wheel within an interval [rad/s], by differences of the wheels' angles.
double fastest_wheel_within(const Robot& robot, Mode mode, const WheelRateRows::Point& q)
{
  constexpr double kStep = 1e-6;
  double greatest = 0.0;
  for (int part = 0; part <= 100; ++part)
  {
    const double phi = q[4] + part / 100.0 * q[6] * q[7];
    const WheelAngles before = wheel_angles(robot, mode, phi - kStep), after = wheel_angles(robot, mode, phi + kStep);
    for (std::size_t i = 0; i < before.size(); ++i)
      greatest = std::max(greatest, std::abs(std::remainder(after[i] - before[i], M_PI)) / (2.0 * kStep));
  }
  return greatest * std::abs(q[6]);
}

struct WheelRates : testing::Test
{
  static WheelRateRows::Point point(double phi, double omega, double h)
  {
    WheelRateRows::Point q = WheelRateRows::Point::Zero();
    q[4] = phi;
    q[6] = omega;
    q[7] = h;
    return q;
  }

  /// Random robots, modes and intervals.
  template <typename Visit>
  void for_intervals(Visit visit)
  {
    for (int trial = 0; trial < 2000; ++trial)
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
      Robot robot;
      robot.wheelbase = random.between(0.4, 1.0);
      robot.track_width = random.between(0.4, 0.6);
      robot.wheel_max_rate = random.between(1.0, 5.0);
      const Mode mode = random.mode();
      const double phi = random.between(-0.7, 0.7), end = random.between(-0.7, 0.7), h = random.between(0.05, 0.5);
      visit(robot, mode, point(phi, (end - phi) / h, h));
    }
  }

  Random random{kSeed};
};

TEST_F(WheelRates, WhereTheRowsHoldNoWheelIsTooFastAllAlongTheInterval)
{
  int held = 0;
  for_intervals([&](const Robot& robot, Mode mode, const WheelRateRows::Point& q) {
    double rows[WheelRateRows::kRows];
    WheelRateRows(robot, mode).evaluate(q, rows);
    if (std::max(rows[0], rows[1]) > 0.0) return;
    ++held;
    EXPECT_LE(fastest_wheel_within(robot, mode, q), robot.wheel_max_rate);
  });
  EXPECT_GT(held, 300);
}

TEST_F(WheelRates, TheRowsForbidHardlyMoreThanTheyMust)
{
  int broken = 0;
  for_intervals([&](const Robot& robot, Mode mode, const WheelRateRows::Point& q) {
    double rows[WheelRateRows::kRows];
    WheelRateRows(robot, mode).evaluate(q, rows);
    if (std::max(rows[0], rows[1]) <= 0.0) return;
    if (std::max(std::abs(q[4]), std::abs(q[4] + q[6] * q[7])) > 0.5) return;  // there they stay at their least
    ++broken;
    EXPECT_GE(fastest_wheel_within(robot, mode, q), 0.85 * robot.wheel_max_rate);
  });
  EXPECT_GT(broken, 300);
}

}  // namespace
}  // namespace fourwis
