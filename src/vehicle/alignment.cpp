#include "fourwis_navigation/vehicle/alignment.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/model/option_range.h"
#include "fourwis_navigation/model/sentence.h"
#include "fourwis_navigation/vehicle/mode_traits.h"
#include "fourwis_navigation/vehicle/wheel_branches.h"

namespace fourwis
{
namespace
{

/// Rounds what is printed with two digits up, so that it is enough.
constexpr double kRoundUp = 0.005;

/// The same for one mode that uses all of its steering angles. The farthest way begins at an end of the travel and leads to
/// an end of the steering. From between two branches it is at most a quarter turn.
double farthest_turn_to(const Robot& robot, Mode mode)
{
  const double limit = max_phi(robot, mode), travel = robot.wheel_max_angle;
  double farthest = 0.0;
  for (const double start : {-limit, limit})
    for (const double end : {-travel, travel})
    {
      PerWheel measured;
      measured.fill(end);
      const BranchedMotion chosen = choose_branches(robot, {mode, start, -limit, limit}, measured);
      // Steering ends where the travel ends: a wheel may have to turn from one end of it to the other.
      if (chosen.beyond) return 2.0 * travel;
      farthest = std::max(farthest, greatest_gap(chosen.motion.angle, measured));
    }
  return farthest;
}

}  // namespace

double farthest_turn(const Robot& robot)
{
  // At a fixed angle there is a branch in each half turn.
  double farthest = std::min(M_PI, 2.0 * robot.wheel_max_angle);
  for (const ModeTraits& traits : kModeTraits)
    if (traits.mode != Mode::none && !traits.follows_phi)
      farthest = std::max(farthest, farthest_turn_to(robot, traits.mode));
  return farthest;
}

void check_alignment_timeout(const Robot& robot, const std::string& key, double timeout, double besides)
{
  const double turn = farthest_turn(robot), needed = turn / robot.wheel_max_rate + besides;
  if (timeout >= needed) return;
  reject_option(
      key, to_text(timeout),
      sentence("at least %.2f s: 'wheel_max_rate' is %s rad/s, and a wheel may have to turn by %.2f rad within "
               "its travel ('wheel_max_angle' is %s rad)",
               needed + kRoundUp, to_text(robot.wheel_max_rate).c_str(), turn, to_text(robot.wheel_max_angle).c_str()));
}

}  // namespace fourwis
