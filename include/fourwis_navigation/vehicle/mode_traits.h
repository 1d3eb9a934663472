#pragma once

#include <cmath>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// A direction in the body's frame with its exact cosine and sine.
struct Course
{
  double angle;  ///< [rad]
  double cosine, sine;
};

/// What a mode does. All formulas about modes are made of these; v is the speed, phi the equivalent steering angle.
struct ModeTraits
{
  Mode mode;

  /// C, the centre of the wheels, moves at speed v. Where it does not, v is the rolling speed of each wheel.
  bool translates;

  /// The direction in which C moves for v > 0, at phi = 0.
  Course course;

  /// The course is phi, and so is the angle of each wheel: phi turns all wheels alike, the body keeps its heading, and
  /// (phi + pi, -v) is the same motion as (phi, v). Where this is false phi does not change the course.
  bool follows_phi;

  /// The distance of the steering axes along the course: the curvature is 2 tan(phi) / base. Null where phi does not
  /// turn the body.
  double Robot::*base;

  /// The distance of the steering axes across the course, null where `base` is.
  double Robot::*gauge;

  /// Turns about C, to the left for v > 0. phi has no effect.
  bool turns_in_place;

  /// What |phi| has to stay within.
  double Robot::*max_phi;

  constexpr bool turns_with_phi() const { return base != nullptr; }

  /// C moves across the body.
  constexpr bool goes_sideways() const { return translates && !follows_phi && course.sine != 0.0; }
};

inline constexpr Course kAhead{0.0, 1.0, 0.0}, kToTheLeft{M_PI_2, 0.0, 1.0};

/// mode, translates, course, follows_phi, base, gauge, turns_in_place, max_phi
inline constexpr ModeTraits kModeTraits[] = {
    {Mode::none, false, kAhead, false, nullptr, nullptr, false, &Robot::max_steering_angle},
    {Mode::ackermann, true, kAhead, false, &Robot::wheelbase, &Robot::track_width, false, &Robot::max_steering_angle},
    {Mode::lateral, true, kToTheLeft, false, &Robot::track_width, &Robot::wheelbase, false, &Robot::max_steering_angle},
    {Mode::parallel, true, kAhead, true, nullptr, nullptr, false, &Robot::wheel_max_angle},
    {Mode::spin, false, kAhead, false, nullptr, nullptr, true, &Robot::max_steering_angle},
};
static_assert(has_a_row_for_each_mode(kModeTraits));

constexpr const ModeTraits& traits_of(Mode mode)
{
  return kModeTraits[index_of(mode)];
}

/// The first mode for which the trait is true; Mode::none if there is none.
constexpr Mode mode_that(bool ModeTraits::*is_true)
{
  for (const ModeTraits& traits : kModeTraits)
    if (traits.*is_true) return traits.mode;
  return Mode::none;
}

/// The mode that goes straight in any direction, and the one that turns in place.
inline constexpr Mode kTranslation = mode_that(&ModeTraits::follows_phi);
inline constexpr Mode kTurnInPlace = mode_that(&ModeTraits::turns_in_place);
static_assert(kTranslation != Mode::none && kTurnInPlace != Mode::none);

/// K in the curvature K tan(phi) of a mode [1/m]; 0 where phi does not turn the body.
inline double curvature_gain(const Robot& robot, Mode mode)
{
  const ModeTraits& traits = traits_of(mode);
  return traits.turns_with_phi() ? 2.0 / (robot.*traits.base) : 0.0;
}

/// What |phi| has to stay within in a mode [rad].
inline double max_phi(const Robot& robot, Mode mode)
{
  return robot.*traits_of(mode).max_phi;
}

/// Whether the heading can change in any of the modes.
constexpr bool can_turn(const ModeSet& modes)
{
  for (const ModeTraits& traits : kModeTraits)
    if (modes.contains(traits.mode) && (traits.turns_with_phi() || traits.turns_in_place)) return true;
  return false;
}

}  // namespace fourwis
