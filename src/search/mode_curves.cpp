#include "mode_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fourwis_navigation/vehicle/kinematics.h"
#include "reeds_shepp.h"

namespace fourwis
{
namespace
{

/// Shorter pieces are rounding [m].
constexpr double kNoLength = 1e-9;

/// The goal in the frame of Reeds and Shepp: x is the course of the mode, the turning radius is one.
Pose in_turning_radii(const Pose& relative, Mode mode, double kappa)
{
  const Course& course = traits_of(mode).course;
  return {(course.cosine * relative.x + course.sine * relative.y) * kappa,
          (course.cosine * relative.y - course.sine * relative.x) * kappa, relative.theta};
}

}  // namespace

ModeCurves::ModeCurves(const Robot& robot, const SearchOptions& options, const MotionCost& cost, const ModeSet& modes)
  : robot_(robot),
    limits_(robot),
    options_(options),
    cost_(cost),
    modes_(modes)
{}

void ModeCurves::candidates(const Pose& from, const Situation& situation, const Pose& goal, double budget,
                            std::vector<ModeCurve>& curves) const
{
  curves.clear();
  Pose relative = relative_to(from, goal);
  relative.theta = wrap_angle(relative.theta);
  for (Mode turning : kPlannedModes)
    if (may_turn_in(turning))
    {
      append_reeds_shepp(relative, turning, budget, curves);
      if (may_translate()) append_turn_and_translate(relative, turning, curves);
    }
  if (may_translate()) append_translation(relative, curves);
  for (ModeCurve& curve : curves) curve.cost = curve_cost(curve, situation);
  const auto useless = [&](const ModeCurve& curve) { return curve.count == 0 || curve.cost >= budget; };
  curves.erase(std::remove_if(curves.begin(), curves.end(), useless), curves.end());
  std::sort(curves.begin(), curves.end(), [](const ModeCurve& a, const ModeCurve& b) { return a.cost < b.cost; });
}

void ModeCurves::append_reeds_shepp(const Pose& relative, Mode mode, double longest,
                                    std::vector<ModeCurve>& curves) const
{
  const double kappa = limits_[mode].curvature;
  ReedsSheppWords words;
  reeds_shepp_words(in_turning_radii(relative, mode, kappa), words);
  for (std::size_t w = 0; w < words.count; ++w)
  {
    const ReedsSheppPath& word = words.paths[w];
    if (word.length / kappa >= longest) continue;
    ModeCurve& curve = curves.emplace_back();
    for (std::size_t i = 0; i < word.count; ++i)
    {
      const ReedsSheppSegment& segment = word.segments[i];
      if (std::abs(segment.length) > kNoLength)
        curve.append(mode, segment.turn * limits_[mode].phi, segment.length / kappa);
    }
  }
}

/// Appends the straight line to (x, y) in the body frame, with a wheel angle in [-pi/2, pi/2]. False if the wheels do not turn
/// that far.
bool ModeCurves::append_straight(double x, double y, ModeCurve& curve) const
{
  const double length = std::hypot(x, y);
  if (length < kNoLength) return true;
  const bool backward = x < 0.0;
  const double phi = backward ? std::atan2(-y, -x) : std::atan2(y, x);
  if (std::abs(phi) > limits_[kTranslation].phi) return false;
  curve.append(kTranslation, phi, backward ? -length : length);
  return true;
}

void ModeCurves::append_translation(const Pose& relative, std::vector<ModeCurve>& curves) const
{
  if (std::abs(relative.theta) > kSameHeading) return;
  ModeCurve curve;
  if (append_straight(relative.x, relative.y, curve)) curves.push_back(curve);
}

void ModeCurves::append_turn_and_translate(const Pose& relative, Mode turning, std::vector<ModeCurve>& curves) const
{
  if (std::abs(relative.theta) <= kSameHeading) return;
  const double kappa = limits_[turning].curvature;
  for (double direction : {1.0, -1.0})
  {
    // Forward, a turn to the left needs phi > 0; backward, phi < 0.
    const double length = direction * std::abs(relative.theta) / kappa;
    const double phi = std::copysign(limits_[turning].phi, relative.theta * direction);
    const Pose turned = advance(robot_, {}, turning, phi, length);

    ModeCurve turn_first;
    turn_first.append(turning, phi, length);
    const Pose rest = relative_to(turned, relative);
    if (append_straight(rest.x, rest.y, turn_first)) curves.push_back(turn_first);

    ModeCurve turn_last;
    const Pose turn_begins = compose(relative, relative_to(turned, Pose{}));
    if (!append_straight(turn_begins.x, turn_begins.y, turn_last)) continue;
    turn_last.append(turning, phi, length);
    curves.push_back(turn_last);
  }
}

double ModeCurves::curve_cost(const ModeCurve& curve, const Situation& situation) const
{
  Mode mode = situation.mode;
  const PathPiece* previous = situation.previous;
  double cost = 0.0;
  for (int i = 0; i < curve.count; ++i)
  {
    const PathPiece& piece = curve.pieces[static_cast<std::size_t>(i)];
    if (piece.mode != mode)
    {
      cost += cost_.mode_switch(situation.at_start && i == 0);
      previous = nullptr;
      mode = piece.mode;
    }
    cost += cost_.piece(piece, previous);
    previous = &piece;
  }
  return cost;
}

void ModeCurves::place(const Pose& from, ModeCurve& curve) const
{
  Pose pose = from;
  for (int i = 0; i < curve.count; ++i)
  {
    PathPiece& piece = curve.pieces[static_cast<std::size_t>(i)];
    piece.start = pose;
    pose = end_of(piece);
  }
}

Pose ModeCurves::end_of(const PathPiece& piece) const
{
  return advance(robot_, piece.start, piece.mode, piece.phi, piece.length);
}

double ModeCurves::length_with_switches(const Pose& from, Mode mode, const Pose& goal) const
{
  Pose relative = relative_to(from, goal);
  relative.theta = wrap_angle(relative.theta);
  double least = std::numeric_limits<double>::infinity();
  const double change = cost_.mode_switch(false);
  const bool same_heading = std::abs(relative.theta) <= kSameHeading;
  if (may_translate() && same_heading)
    least = std::hypot(relative.x, relative.y) + (mode == kTranslation ? 0.0 : change);
  for (Mode turning : kPlannedModes)
  {
    if (!may_turn_in(turning)) continue;
    const double kappa = limits_[turning].curvature;
    const double length = reeds_shepp_length(in_turning_radii(relative, turning, kappa)) / kappa;
    least = std::min(least, length + (mode == turning ? 0.0 : change));
    if (!may_translate() || same_heading) continue;
    const double turn = std::abs(relative.theta) / kappa;
    const double straight = std::max(0.0, std::hypot(relative.x, relative.y) - turn);
    const int switches = mode == turning || mode == kTranslation ? 1 : 2;
    least = std::min(least, turn + straight + switches * change);
  }
  return least;
}

bool is_free(const CollisionChecker& checker, const ModeCurve& curve)
{
  for (int i = 0; i < curve.count; ++i)
    if (!checker.is_free(curve.pieces[static_cast<std::size_t>(i)])) return false;
  return true;
}

}  // namespace fourwis
