#pragma once

#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// The paper's state x = (x, y, theta, v, phi).
struct MotionState
{
  Pose pose;
  double v = 0.0;    ///< [m/s]
  double phi = 0.0;  ///< [rad]
};

/// The paper's input u = (a, omega).
struct MotionInput
{
  double a = 0.0;      ///< [m/s^2]
  double omega = 0.0;  ///< [rad/s]
};

}  // namespace fourwis
