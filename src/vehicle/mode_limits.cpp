#include "fourwis_navigation/vehicle/mode_limits.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/model/sentence.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_traits.h"
#include "fourwis_navigation/vehicle/wheel_branches.h"
#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

/// Halvings of the range in which the greatest phi lies: 1e-12 rad.
constexpr int kHalvings = 40;
/// So that a wheel at the greatest phi stays within its travel in spite of rounding [rad].
constexpr double kReserve = 1e-7;

/// Whether the wheels can follow phi everywhere within +-greatest without a standstill.
bool can_follow(const Robot& robot, Mode mode, double greatest)
{
  return !choose_branches(robot, {mode, 0.0, -greatest, greatest}, {}).beyond;
}

double greatest_phi(const Robot& robot, Mode mode)
{
  const double wanted = max_phi(robot, mode);
  if (!traits_of(mode).turns_with_phi() || can_follow(robot, mode, wanted)) return wanted;
  double possible = 0.0, impossible = wanted;
  for (int k = 0; k < kHalvings; ++k)
  {
    const double middle = (possible + impossible) / 2.0;
    (can_follow(robot, mode, middle) ? possible : impossible) = middle;
  }
  return std::max(0.0, possible - kReserve);
}

}  // namespace

DriveLimits::DriveLimits(const Robot& robot)
{
  for (const ModeName& name : kModes)
  {
    const Mode mode = name.mode;
    ModeLimits& limits = limits_[mode];
    limits.possible = mode != Mode::none && can_follow(robot, mode, 0.0);
    if (!limits.possible) continue;
    limits.phi = greatest_phi(robot, mode);
    if (traits_of(mode).turns_with_phi()) limits.curvature = curvature(robot, mode, limits.phi);
  }
}

ModeSet DriveLimits::possible() const
{
  ModeSet modes = ModeSet::none();
  for (Mode mode : kPlannedModes)
    if ((*this)[mode].possible) modes.insert(mode);
  return modes;
}

std::vector<std::string> limitations(const Robot& robot)
{
  const DriveLimits limits(robot);
  std::vector<std::string> sentences;
  for (Mode mode : kPlannedModes)
  {
    const char* name = to_string(mode);
    if (!limits[mode].possible)
      sentences.push_back(sentence("%s motion is left out: no wheel turns that far within 'wheel_max_angle' = %.4g rad",
                                   name, robot.wheel_max_angle));
    else if (traits_of(mode).turns_with_phi() && limits[mode].phi < robot.max_steering_angle)
      sentences.push_back(sentence(
          "%s motion steers by %.4g rad at most instead of 'max_steering_angle' = %.4g rad: the wheels turn within "
          "'wheel_max_angle' = %.4g rad",
          name, limits[mode].phi, robot.max_steering_angle, robot.wheel_max_angle));
  }
  return sentences;
}

double greatest_speed(const Robot& robot, Mode mode, double phi)
{
  return std::min(robot.max_speed, robot.wheel_max_speed / wheel_speed_ratio(robot, mode, phi));
}

}  // namespace fourwis
