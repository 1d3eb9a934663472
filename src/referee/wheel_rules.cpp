#include <algorithm>
#include <cmath>
#include <string>

#include "fourwis_navigation/model/sentence.h"
#include "rules.h"
#include "wheels.h"

namespace fourwis::referee
{
namespace
{

constexpr double kSwitchPosition = 1e-6;  // a switch keeps the pose within this [m]
constexpr double kSwitchAngle = 1e-6;     // [rad]
constexpr double kTimeRounding = 1e-9;    // [s]
constexpr int kSpeedSamples = 256;        // of an interval in which a wheel may be too fast

const char* const kWheelNames[kWheels] = {"front left wheel", "front right wheel", "rear left wheel",
                                          "rear right wheel"};

std::string of_wheel(const char* quantity, int wheel)
{
  return quantity + std::string(" of the ") + kWheelNames[wheel];
}

/// The rules that concern the interval after one point.
class IntervalJudge
{
public:
  IntervalJudge(const Judgement& judgement, const Wheels& wheels) : judgement_(judgement), wheels_(wheels) {}

  void check_switch(std::size_t i) const
  {
    const TrajectoryPoint &p = judgement_.trajectory[i], &next = judgement_.trajectory[i + 1];
    const double moved = distance(p.pose(), next.pose()), turned = std::abs(next.theta - p.theta);
    if (moved > kSwitchPosition)
      judgement_.report.add(i, p.t, "motion during a mode switch", moved, kSwitchPosition, "m");
    if (turned > kSwitchAngle) judgement_.report.add(i, p.t, "turn during a mode switch", turned, kSwitchAngle, "rad");
    if (!at_rest(p)) judgement_.report.add(i, p.t, "speed at a mode switch", p.v, kRestSpeed, "m/s");
    if (!at_rest(next)) judgement_.report.add(i + 1, next.t, "speed at a mode switch", next.v, kRestSpeed, "m/s");
    check_duration(i, judgement_.robot.mode_switch_time, "duration of a mode switch");
    check_turn_at_rest(i);
  }

  /// At rest the wheels need not follow phi: they may turn the shorter way.
  void check_turn_at_rest(std::size_t i) const
  {
    const TrajectoryPoint &p = judgement_.trajectory[i], &next = judgement_.trajectory[i + 1];
    if (p.mode == next.mode && p.phi == next.phi) return;
    for (int wheel = 0; wheel < kWheels; ++wheel)
    {
      const double turn = wheels_.least_turn(wheel, p.mode, p.phi, next.mode, next.phi);
      check_duration(i, turn / judgement_.robot.wheel_max_rate, "time to turn at rest", wheel);
    }
  }

  void check_wheel_rates(std::size_t i) const
  {
    const TrajectoryPoint &p = judgement_.trajectory[i], &next = judgement_.trajectory[i + 1];
    if (p.phi == next.phi) return;
    const double duration = next.t - p.t, change = std::abs(next.phi - p.phi);
    if (change * wheels_.greatest_gain(p.mode) <= judgement_.robot.wheel_max_rate * duration) return;
    const PhiRange range{std::min(p.phi, next.phi), std::max(p.phi, next.phi)};
    for (int wheel = 0; wheel < kWheels; ++wheel)
    {
      const double turn = wheels_.motion(p.mode, wheel).greatest_gain(range) * change;
      if (turn > judgement_.lenient(judgement_.robot.wheel_max_rate) * duration + kRounding)
        judgement_.report.add(i, p.t, of_wheel("steering rate", wheel).c_str(), turn / duration,
                              judgement_.robot.wheel_max_rate, "rad/s");
    }
  }

  void check_wheel_speeds(std::size_t i) const
  {
    const TrajectoryPoint &p = judgement_.trajectory[i], &next = judgement_.trajectory[i + 1];
    const double greatest = std::max(std::abs(p.v), std::abs(next.v)), limit = judgement_.robot.wheel_max_speed;
    if (greatest * wheels_.greatest_speed_factor(p.mode) <= limit) return;
    for (int wheel = 0; wheel < kWheels; ++wheel)
    {
      const WheelMotion& motion = wheels_.motion(p.mode, wheel);
      if (greatest * std::max(motion.speed_factor(p.phi), motion.speed_factor(next.phi)) <= judgement_.lenient(limit))
        continue;
      const double speed = greatest_wheel_speed(motion, p, next);
      if (speed > judgement_.lenient(limit))
        judgement_.report.add(i, p.t, of_wheel("rolling speed", wheel).c_str(), speed, limit, "m/s");
    }
  }

private:
  /// `needed` is a lower limit [s].
  void check_duration(std::size_t i, double needed, const char* quantity, int wheel = -1) const
  {
    const double t = judgement_.trajectory[i].t, duration = judgement_.trajectory[i + 1].t - t;
    if (duration >= needed * (1.0 - judgement_.options.limit_tolerance) - kTimeRounding) return;
    const std::string name = wheel < 0 ? quantity : of_wheel(quantity, wheel);
    judgement_.report.add(i, t, sentence("%s %.9g s, limit at least %.9g s", name.c_str(), duration, needed));
  }

  static double greatest_wheel_speed(const WheelMotion& motion, const TrajectoryPoint& from, const TrajectoryPoint& to)
  {
    double greatest = 0.0;
    for (int k = 0; k <= kSpeedSamples; ++k)
    {
      const double share = static_cast<double>(k) / kSpeedSamples;
      const double v = from.v + share * (to.v - from.v), phi = from.phi + share * (to.phi - from.phi);
      greatest = std::max(greatest, std::abs(v) * motion.speed_factor(phi));
    }
    return greatest;
  }

  const Judgement& judgement_;
  const Wheels& wheels_;
};

/// A stretch without rest: the wheels follow phi, each on one branch.
void check_travel(const Judgement& judgement, const Wheels& wheels, std::size_t first, std::size_t last)
{
  const TrajectoryPoint& p = judgement.trajectory[first];
  PhiRange range{p.phi, p.phi};
  for (std::size_t i = first; i <= last; ++i)
  {
    range.low = std::min(range.low, judgement.trajectory[i].phi);
    range.high = std::max(range.high, judgement.trajectory[i].phi);
  }
  for (int wheel = 0; wheel < kWheels; ++wheel)
  {
    if (wheels.has_branch(p.mode, wheel, range)) continue;
    const WheelMotion& motion = wheels.motion(p.mode, wheel);
    judgement.report.add(
        first, p.t,
        sentence("angle of the %s from %.9g to %.9g rad without rest, limit +-%.9g rad", kWheelNames[wheel],
                 motion.angle(range.low), motion.angle(range.high), judgement.robot.wheel_max_angle));
  }
}

}  // namespace

void check_wheels(const Judgement& judgement)
{
  judgement.report.next_kind();
  const Wheels wheels(judgement.robot);
  const IntervalJudge interval(judgement, wheels);
  const Trajectory& points = judgement.trajectory;
  std::size_t stretch = 0;  // where the stretch without rest began
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const bool switching = points[i].mode != points[i + 1].mode;
    if (switching || (at_rest(points[i]) && at_rest(points[i + 1])))
    {
      if (i > stretch) check_travel(judgement, wheels, stretch, i);
      stretch = i + 1;
      switching ? interval.check_switch(i) : interval.check_turn_at_rest(i);
      continue;
    }
    interval.check_wheel_rates(i);
    interval.check_wheel_speeds(i);
  }
  if (stretch + 1 < points.size()) check_travel(judgement, wheels, stretch, points.size() - 1);
}

}  // namespace fourwis::referee
