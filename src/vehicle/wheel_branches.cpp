#include "fourwis_navigation/vehicle/wheel_branches.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fourwis_navigation/vehicle/mode_traits.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"
#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

constexpr double kRounding = 1e-9;  // for a wheel at the very end of its travel [rad]

/// Angles over a stretch, without jumps, on some branch.
struct Sweep
{
  double start, low, high;
};

/// In modes that follow phi, the angle of a wheel is phi without a limit. In the other modes the velocity of a wheel
/// moves along a straight line as tan(phi) grows. So its direction turns one way only, and by less than pi on either
/// side of phi = 0.
Sweep sweep_of(const Robot& robot, const SteeringStretch& stretch, std::size_t wheel)
{
  if (traits_of(stretch.mode).follows_phi) return {stretch.start, stretch.low, stretch.high};
  const double straight = wheel_angles(robot, stretch.mode, 0.0)[wheel];
  const auto angle = [&](double phi) {
    return straight + std::remainder(wheel_angles(robot, stretch.mode, phi)[wheel] - straight, 2.0 * M_PI);
  };
  const double a = angle(stretch.low), b = angle(stretch.high);
  return {angle(stretch.start), std::min(a, b), std::max(a, b)};
}

struct Branch
{
  double shift;   ///< a multiple of pi [rad]
  double excess;  ///< how far it goes beyond the travel [rad]
};

/// The branch nearest to the measured angle among those within the travel. If there is none, the one that exceeds the
/// travel least.
Branch nearest_branch(const Sweep& sweep, double measured, double travel)
{
  const double centre = (sweep.low + sweep.high) / 2.0, reachable = travel + kRounding;
  const double middle = -std::round(centre / M_PI);  // brings the sweep to the middle of the travel
  const int reach = static_cast<int>(travel / M_PI) + 1;
  Branch best{0.0, std::numeric_limits<double>::infinity()};
  double least = std::numeric_limits<double>::infinity();
  for (int k = -reach; k <= reach; ++k)
  {
    const double shift = (middle + k) * M_PI;
    const double excess = std::max({0.0, sweep.high + shift - reachable, -reachable - sweep.low - shift});
    const double turn = std::abs(sweep.start + shift - measured);
    if (excess > best.excess || (excess == best.excess && turn >= least)) continue;
    best = {shift, excess};
    least = turn;
  }
  return best;
}

}  // namespace

BranchedMotion choose_branches(const Robot& robot, const SteeringStretch& stretch, const PerWheel& measured)
{
  BranchedMotion chosen;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const Sweep sweep = sweep_of(robot, stretch, i);
    const Branch branch = nearest_branch(sweep, measured[i], robot.wheel_max_angle);
    chosen.motion.angle[i] = sweep.start + branch.shift;
    if (branch.excess == 0.0 || chosen.beyond) continue;
    const double low = sweep.low + branch.shift, high = sweep.high + branch.shift;
    chosen.beyond = BeyondTravel{static_cast<int>(i), high > -low ? high : low};
  }
  return chosen;
}

BranchedMotion continue_branches(const Robot& robot, const WheelMotion& motion, const PerWheel& previous)
{
  BranchedMotion continued;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const double half_turns = std::round((previous[i] - motion.angle[i]) / M_PI);
    const bool reversed = std::remainder(half_turns, 2.0) != 0.0;
    continued.motion.angle[i] = motion.angle[i] + half_turns * M_PI;
    continued.motion.speed[i] = reversed ? -motion.speed[i] : motion.speed[i];
    const bool within = std::abs(continued.motion.angle[i]) <= robot.wheel_max_angle + kRounding;  // NaN is not
    if (!within && !continued.beyond) continued.beyond = BeyondTravel{static_cast<int>(i), continued.motion.angle[i]};
  }
  return continued;
}

}  // namespace fourwis
