#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// What the wheels of a robot can do in one mode.
struct ModeLimits
{
  bool possible = false;   ///< whether the wheels can stand as the mode asks at all
  double phi = 0.0;        ///< greatest |phi| [rad]
  double curvature = 0.0;  ///< of the path at that phi, 0 where phi does not turn the body [1/m]
};

/// The same for all modes. `Robot::max_steering_angle` bounds phi, and so does the travel of each wheel: without a standstill
/// phi may pass through everything between its limits, and no wheel can change its branch on the way (wheel_branches.h).
class DriveLimits
{
public:
  explicit DriveLimits(const Robot& robot);

  const ModeLimits& operator[](Mode mode) const { return limits_[mode]; }

  /// The planned modes that the wheels can do.
  ModeSet possible() const;

private:
  PerMode<ModeLimits> limits_;
};

/// A sentence for each planned mode that the wheels cannot do, and for each in which they cannot reach
/// `Robot::max_steering_angle`.
std::vector<std::string> limitations(const Robot& robot);

/// Speed of C, the centre of the wheels, at which no wheel rolls faster than it can and C is not faster than
/// `Robot::max_speed` [m/s].
double greatest_speed(const Robot& robot, Mode mode, double phi);

}  // namespace fourwis
