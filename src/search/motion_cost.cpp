#include "motion_cost.h"

#include <cmath>

#include "fourwis_navigation/vehicle/mode_traits.h"

namespace fourwis
{

MotionCost::MotionCost(const Robot& robot, const SearchOptions& options)
  : options_(options),
    per_metre_(1.0 / options.primitive_length()),
    switch_(0.0),
    switch_at_start_(0.0)
{
  if (!options.switching_awareness) return;
  const double v = options.reference_speed;
  const double waiting = v * robot.mode_switch_time, stopping = v * v / robot.max_acceleration;
  switch_ = waiting + stopping;
  switch_at_start_ = waiting + stopping / 2.0;
}

double MotionCost::piece(const PathPiece& piece, const PathPiece* previous) const
{
  const double length = std::abs(piece.length), primitives = length * per_metre_;
  const ModeTraits& traits = traits_of(piece.mode);
  const double steer = traits.follows_phi ? options_.parallel_steering_penalty : options_.steering_penalty;
  const double reverse = traits.goes_sideways() ? options_.lateral_reverse_penalty : options_.reverse_penalty;
  double cost = length + primitives * steer * std::abs(piece.phi);
  if (piece.length < 0.0) cost += primitives * reverse;
  if (!previous || previous->mode != piece.mode) return cost;
  cost += options_.steering_change_penalty * std::abs(piece.phi - previous->phi);
  if (std::signbit(piece.length) != std::signbit(previous->length)) cost += options_.direction_change_penalty;
  return cost;
}

}  // namespace fourwis
