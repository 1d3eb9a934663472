#include "motion_cost.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/mode_limits.h"
#include "fourwis_navigation/vehicle/mode_traits.h"

namespace fourwis
{
namespace
{

/// Each of the two costs of a switch is no more than this, in sizes of the robot: greater ones would make a search look
/// everywhere else first. Which path is the fastest is told later, by their times.
constexpr double kMostSwitchCost = 2.5;

}  // namespace

MotionCost::MotionCost(const Robot& robot, const SearchOptions& options)
  : robot_(robot),
    options_(options),
    v_ref_(options.v_ref(robot)),
    per_metre_(1.0 / options.primitive_length(robot)),
    switch_(0.0),
    switch_at_start_(0.0)
{
  const DriveLimits limits(robot);
  for (Mode mode : kPlannedModes)
  {
    greatest_phi_[mode] = limits[mode].phi;
    straight_[mode] = std::max(1.0, v_ref_ / greatest_speed(robot, mode, 0.0));
    at_lock_[mode] = std::max(1.0, v_ref_ / greatest_speed(robot, mode, limits[mode].phi));
  }
  if (!options.switching_awareness) return;
  const double v = v_ref_;
  const double most = kMostSwitchCost * robot.size();
  const double waiting = std::min(most, v * robot.mode_switch_time),
               stopping = std::min(most, v * v / robot.max_acceleration);
  switch_ = waiting + stopping;
  switch_at_start_ = waiting + stopping / 2.0;
}

double MotionCost::slowness(Mode mode, double phi) const
{
  if (phi == 0.0 || traits_of(mode).follows_phi) return straight_[mode];
  if (std::abs(phi) == greatest_phi_[mode]) return at_lock_[mode];
  return std::max(1.0, v_ref_ / greatest_speed(robot_, mode, phi));
}

double MotionCost::piece(const PathPiece& piece, const PathPiece* previous) const
{
  const double length = std::abs(piece.length), primitives = length * per_metre_;
  const ModeTraits& traits = traits_of(piece.mode);
  const double steer = traits.follows_phi ? options_.parallel_steering_penalty : options_.steering_penalty;
  const double reverse = traits.goes_sideways() ? options_.lateral_reverse_penalty : options_.reverse_penalty;
  double cost = slowness(piece.mode, piece.phi) * length + primitives * steer * std::abs(piece.phi);
  if (piece.length < 0.0) cost += primitives * reverse;
  if (!previous || previous->mode != piece.mode) return cost;
  cost += options_.steering_change_penalty * std::abs(piece.phi - previous->phi);
  if (std::signbit(piece.length) != std::signbit(previous->length)) cost += options_.direction_change_penalty;
  return cost;
}

}  // namespace fourwis
