#include "check_trajectory.h"

#include <cmath>
#include <sstream>
#include <vector>

#include "fourwis_navigation/vehicle/mode_traits.h"
#include "roll_out.h"

namespace fourwis
{
namespace
{

constexpr double kPosition = 0.005, kAngle = 0.01;  ///< a roll-out may miss the next point by that much [m, rad]
constexpr double kSamePlace = 1e-3;                 ///< poses at a switch [m, rad]
constexpr double kRest = 1e-6;                      ///< [m/s]
constexpr double kRounding = 1e-4;                  ///< relative excess of a limit
constexpr double kLongest = 3600.0;                 ///< [s]

std::string at_point(std::size_t k, const std::string& what, double value)
{
  std::ostringstream text;
  text << "trajectory point " << k << ": " << what << " (" << value << ")";
  return text.str();
}

bool is_finite(const TrajectoryPoint& p)
{
  return std::isfinite(p.t) && is_finite(p.pose()) && std::isfinite(p.v) && std::isfinite(p.phi);
}

std::string check_point(const Robot& robot, const Trajectory& points, std::size_t k)
{
  const TrajectoryPoint& p = points[k];
  if (!is_finite(p)) return at_point(k, "holds something that is no finite number", p.t);
  if (!is_planned(p.mode)) return at_point(k, "its mode is not known", double(p.mode));
  if (k > 0 && !(p.t > points[k - 1].t)) return at_point(k, "its time is not later than the one before [s]", p.t);
  if (p.t - points.front().t > kLongest) return at_point(k, "it lies more than an hour ahead [s]", p.t);
  if (std::abs(p.v) > robot.max_speed * (1.0 + kRounding)) return at_point(k, "faster than max_speed [m/s]", p.v);
  if (std::abs(p.phi) > max_phi(robot, p.mode) * (1.0 + kRounding))
    return at_point(k, "steers more than the robot can [rad]", p.phi);
  return {};
}

std::string check_switch(const Trajectory& points, std::size_t k)
{
  const TrajectoryPoint &from = points[k], &to = points[k + 1];
  if (std::abs(from.v) > kRest || std::abs(to.v) > kRest)
    return at_point(k, "is not at rest at a switch [m/s]", from.v);
  if (distance(from.pose(), to.pose()) > kSamePlace || std::abs(to.theta - from.theta) > kSamePlace)
    return at_point(k, "does not keep its pose at a switch [m]", distance(from.pose(), to.pose()));
  return {};
}

std::string check_interval(const Robot& robot, const Trajectory& points, std::size_t k)
{
  const TrajectoryPoint &from = points[k], &to = points[k + 1];
  const double h = to.t - from.t;
  const MotionInput input = {(to.v - from.v) / h, (to.phi - from.phi) / h};
  if (std::abs(input.a) > robot.max_acceleration * (1.0 + kRounding))
    return at_point(k, "accelerates more than max_acceleration [m/s^2]", input.a);
  if (std::abs(input.omega) > robot.max_steering_rate * (1.0 + kRounding))
    return at_point(k, "steers faster than max_steering_rate [rad/s]", input.omega);
  constexpr int parts = 10;
  MotionState state = {from.pose(), from.v, from.phi};
  for (int i = 0; i < parts; ++i) state = roll_out(robot, from.mode, state, input, h / parts);
  const double miss = distance(state.pose, to.pose()), turn = std::abs(state.pose.theta - to.theta);
  if (miss > kPosition) return at_point(k, "its motion misses the next point [m]", miss);
  if (turn > kAngle) return at_point(k, "its motion misses the next heading [rad]", turn);
  return {};
}

}  // namespace

std::string check_trajectory(const Robot& robot, const Trajectory& trajectory)
{
  for (std::size_t k = 0; k < trajectory.size(); ++k)
    if (std::string complaint = check_point(robot, trajectory, k); !complaint.empty()) return complaint;
  for (std::size_t k : {std::size_t(0), trajectory.size() - 1})
    if (std::abs(trajectory[k].v) > kRest) return at_point(k, "is not at rest [m/s]", trajectory[k].v);
  for (std::size_t k = 0; k + 1 < trajectory.size(); ++k)
  {
    const bool switches = trajectory[k].mode != trajectory[k + 1].mode;
    std::string complaint = switches ? check_switch(trajectory, k) : check_interval(robot, trajectory, k);
    if (!complaint.empty()) return complaint;
  }
  return {};
}

}  // namespace fourwis
