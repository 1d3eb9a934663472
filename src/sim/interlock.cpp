#include "fourwis_navigation/sim/interlock.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{
namespace
{

/// Sums of time steps may be too small by rounding. They count as reached within this [s].
constexpr double kRounding = 1e-9;

}  // namespace

Interlock::Interlock(const InterlockOptions& options) : options_(checked(options)) {}

void Interlock::command(Mode mode, const PerWheel& angle)
{
  if (stage_ == Stage::failed) return;
  if (mode != mode_ || greatest_gap(angle, angle_) > options_.largest_jump)
  {
    stage_ = mode == Mode::none ? Stage::locked : Stage::coming_to_rest;
    waiting_ = 0.0;
  }
  mode_ = mode;
  angle_ = angle;
  if (greatest_gap(angle_, measured_angle_) > options_.aligned_angle) aligned_ = 0.0;
}

void Interlock::step(double duration, const WheelMotion& measured)
{
  measured_angle_ = measured.angle;
  const bool slow = greatest_magnitude(measured.speed) < options_.standstill_speed;
  const bool near = greatest_gap(angle_, measured_angle_) <= options_.aligned_angle;
  standstill_ = slow ? standstill_ + duration : 0.0;
  aligned_ = near ? aligned_ + duration : 0.0;
  waiting_ = is_waiting() ? waiting_ + duration : 0.0;
  advance();
}

void Interlock::reset()
{
  stage_ = Stage::locked;
  mode_ = Mode::none;
}

bool Interlock::at_standstill() const
{
  return standstill_ >= options_.standstill_time - kRounding;
}

bool Interlock::aligned() const
{
  return may_turn() && aligned_ >= options_.aligned_time - kRounding;
}

bool Interlock::is_waiting() const
{
  return stage_ == Stage::coming_to_rest || stage_ == Stage::aligning;
}

void Interlock::advance()
{
  if (stage_ == Stage::coming_to_rest && at_standstill())
  {
    stage_ = Stage::aligning;
    waiting_ = 0.0;
  }
  if (stage_ == Stage::aligning && aligned()) stage_ = Stage::released;
  if (is_waiting() && waiting_ > options_.alignment_timeout) stage_ = Stage::failed;
}

}  // namespace fourwis
