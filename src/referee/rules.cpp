#include "rules.h"

#include <cmath>
#include <string>

namespace fourwis::referee
{
namespace
{

// Greater numbers are rejected as unusable [s, m, rad, ...], so that no sum or product of two numbers overflows.
constexpr double kGreatestNumber = 1e9;

// `a` and `omega` must agree with the differences within this share of the limit.
constexpr double kRateAgreement = 1e-3;

bool all_sane(const TrajectoryPoint& p)
{
  for (const double number : {p.t, p.x, p.y, p.theta, p.v, p.phi, p.a, p.omega})
    if (!(std::abs(number) <= kGreatestNumber)) return false;
  return true;
}

void check_pose(const Judgement& judgement, std::size_t point, const char* name, const Pose& wanted)
{
  const TrajectoryPoint& p = judgement.trajectory[point];
  const double position = distance(p.pose(), wanted), angle = std::abs(wrap_angle(p.theta - wanted.theta));
  const std::string which = name;
  if (!(position <= judgement.options.endpoint_position))
    judgement.report.add(point, p.t, ("distance from the " + which + " position").c_str(), position,
                         judgement.options.endpoint_position, "m");
  if (!(angle <= judgement.options.endpoint_angle))
    judgement.report.add(point, p.t, ("angle from the " + which + " heading").c_str(), angle,
                         judgement.options.endpoint_angle, "rad");
  if (!at_rest(p)) judgement.report.add(point, p.t, ("speed at the " + which).c_str(), p.v, kRestSpeed, "m/s");
}

void check_point(const Judgement& judgement, std::size_t i)
{
  const TrajectoryPoint& p = judgement.trajectory[i];
  const double max_phi =
      p.mode == Mode::parallel ? judgement.robot.wheel_max_angle : judgement.robot.max_steering_angle;
  if (std::abs(p.v) > judgement.lenient(judgement.robot.max_speed))
    judgement.report.add(i, p.t, "speed", p.v, judgement.robot.max_speed, "m/s");
  if (std::abs(p.phi) > judgement.lenient(max_phi))
    judgement.report.add(i, p.t, "steering angle", p.phi, max_phi, "rad");
}

/// Checks a rate: the difference over an interval must keep the limit and agree with the rate that the point states.
void check_rate(const Judgement& judgement, std::size_t i, double duration, double difference, double claimed,
                double limit, const char* name, const char* unit)
{
  const double t = judgement.trajectory[i].t;
  if (std::abs(difference) > judgement.lenient(limit) * duration + kRounding)
    judgement.report.add(i, t, name, difference / duration, limit, unit);
  if (std::abs(difference - claimed * duration) > kRateAgreement * limit * duration + kRounding)
    judgement.report.add(i, t, ("difference of the claimed and the actual " + std::string(name)).c_str(),
                         claimed - difference / duration, kRateAgreement * limit, unit);
}

}  // namespace

bool check_form(const Judgement& judgement)
{
  judgement.report.next_kind();
  const Trajectory& points = judgement.trajectory;
  if (points.empty())
  {
    judgement.report.add(0, 0.0, "no points, expected at least one");
    return false;
  }
  bool sound = true;
  const auto broken = [&](std::size_t i, const std::string& what) {
    judgement.report.add(i, points[i].t, what);
    sound = false;
  };
  for (std::size_t i = 0; i < points.size() && !judgement.report.full(); ++i)
  {
    if (!all_sane(points[i])) broken(i, "a number is not finite or beyond 1e9");
    if (!ModeSet().contains(points[i].mode))
      broken(i, "mode number " + std::to_string(static_cast<int>(points[i].mode)) +
                    ", expected 1 ackermann, 2 lateral or 3 parallel");
    if (i > 0 && !(points[i].t > points[i - 1].t)) broken(i, "time not after the time of the point before");
  }
  if (!(std::abs(points.front().t) <= kRounding)) broken(0, "time of the first point not 0 s");
  return sound;
}

void check_ends(const Judgement& judgement, const Pose& start, const Pose& goal)
{
  judgement.report.next_kind();
  check_pose(judgement, 0, "start", start);
  judgement.report.next_kind();
  check_pose(judgement, judgement.trajectory.size() - 1, "goal", goal);
}

void check_limits(const Judgement& judgement)
{
  judgement.report.next_kind();
  const Trajectory& points = judgement.trajectory;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    check_point(judgement, i);
    if (i + 1 == points.size() || points[i].mode != points[i + 1].mode) continue;
    const TrajectoryPoint &p = points[i], &next = points[i + 1];
    const double duration = next.t - p.t;
    check_rate(judgement, i, duration, next.v - p.v, p.a, judgement.robot.max_acceleration, "acceleration", "m/s^2");
    check_rate(judgement, i, duration, next.phi - p.phi, p.omega, judgement.robot.max_steering_rate, "steering rate",
               "rad/s");
  }
}

}  // namespace fourwis::referee
