#pragma once

#include <gtest/gtest.h>

#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{

inline void expect_twist(const Twist& twist, const Twist& expected, double accuracy)
{
  EXPECT_NEAR(twist.vx, expected.vx, accuracy);
  EXPECT_NEAR(twist.vy, expected.vy, accuracy);
  EXPECT_NEAR(twist.omega, expected.omega, accuracy);
}

}  // namespace fourwis
