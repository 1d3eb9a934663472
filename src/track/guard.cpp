#include "guard.h"

#include <algorithm>
#include <cmath>

namespace fourwis
{
namespace
{

/// Clocks of two computers may differ by this much [s].
constexpr double kAhead = 0.05;

/// A wheel may be away from its angle for this long, because of a bump, noise or a late command [s].
constexpr double kWheelErrorTimeout = 0.3;

constexpr const char* kWheelAway[] = {"the front left wheel is %.3f rad from its angle, max_wheel_error is %.3f rad",
                                      "the front right wheel is %.3f rad from its angle, max_wheel_error is %.3f rad",
                                      "the rear left wheel is %.3f rad from its angle, max_wheel_error is %.3f rad",
                                      "the rear right wheel is %.3f rad from its angle, max_wheel_error is %.3f rad"};

StopReason judge_age(double age, double timeout, const char* too_old, const char* ahead)
{
  if (age > timeout) return {too_old, age, timeout};
  if (age < -kAhead) return {ahead, -age};
  return {};
}

bool is_finite(const PerWheel& numbers)
{
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

StopReason judge_numbers(const TrackInput& input)
{
  if (!std::isfinite(input.now)) return {"the time is no number"};
  if (!std::isfinite(input.pose_stamp) || !is_finite(input.pose)) return {"the robot's pose is not known"};
  if (!std::isfinite(input.wheels.stamp) || !is_finite(input.wheels.motion.angle) ||
      !is_finite(input.wheels.motion.speed))
    return {"the wheels' state holds something that is no number"};
  return {};
}

StopReason judge_base(BaseState state)
{
  switch (state)
  {
    case BaseState::enabled: return {};
    case BaseState::not_ready: return {"the base is not ready"};
    case BaseState::ready: return {"the base is not enabled"};
    case BaseState::stopping: return {"the base stops by itself"};
    case BaseState::fault: return {"the base has a fault"};
  }
  return {"the base's state is unknown"};
}

}  // namespace

double turn_between(const Pose& a, const Pose& b)
{
  return std::abs(wrap_angle(a.theta - b.theta));
}

bool is_within(const Pose& a, const Pose& b, double xy, double yaw)
{
  return distance(a, b) <= xy && turn_between(a, b) <= yaw;
}

StopReason judge_input(const TrackInput& input, const TrackOptions& options)
{
  if (const StopReason reason = judge_numbers(input)) return reason;
  if (const StopReason reason =
          judge_age(input.now - input.pose_stamp, options.pose_timeout,
                    "the pose is %.3f s old, pose_timeout is %.3f s", "the pose's stamp lies %.3f s ahead"))
    return reason;
  if (const StopReason reason = judge_age(input.now - input.wheels.stamp, options.wheel_state_timeout,
                                          "the wheels' state is %.3f s old, wheel_state_timeout is %.3f s",
                                          "the stamp of the wheels' state lies %.3f s ahead"))
    return reason;
  return judge_base(input.wheels.state);
}

StopReason judge_deviation(const Deviation& deviation, const TrackOptions& options)
{
  if (std::abs(deviation.lateral) > options.max_lateral_error)
    return {"the robot is %.3f m beside the trajectory, max_lateral_error is %.3f m", std::abs(deviation.lateral),
            options.max_lateral_error};
  if (std::abs(deviation.longitudinal) > options.max_longitudinal_error)
    return {"the robot is %.3f m from where it should be on the trajectory, max_longitudinal_error is %.3f m",
            std::abs(deviation.longitudinal), options.max_longitudinal_error};
  if (std::abs(deviation.heading) > options.max_heading_error)
    return {"the robot's heading is off by %.3f rad, max_heading_error is %.3f rad", std::abs(deviation.heading),
            options.max_heading_error};
  return {};
}

StopReason WheelWatch::judge(const PerWheel& expected, const PerWheel& measured, double period)
{
  for (std::size_t i = 0; i < away_.size(); ++i)
  {
    const double error = std::abs(std::remainder(measured[i] - expected[i], M_PI));
    away_[i] = error > options_.max_wheel_error ? away_[i] + period : 0.0;
    if (away_[i] > kWheelErrorTimeout) return {kWheelAway[i], error, options_.max_wheel_error};
  }
  return {};
}

bool is_at_rest(const WheelState& wheels, const TrackOptions& options)
{
  return std::all_of(wheels.motion.speed.begin(), wheels.motion.speed.end(),
                     [&](double speed) { return std::abs(speed) <= options.rest_speed; });
}

}  // namespace fourwis
