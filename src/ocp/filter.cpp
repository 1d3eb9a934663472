#include "fourwis_navigation/ocp/filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fourwis::ocp
{
namespace
{

constexpr double kViolationMargin = 1e-5;  // gamma_theta
constexpr double kBarrierMargin = 1e-8;    // gamma_phi
constexpr double kArmijo = 1e-8;           // eta_phi

/// Differences of barrier values below this are rounding.
double rounding(double barrier)
{
  return 10.0 * std::numeric_limits<double>::epsilon() * std::abs(barrier);
}

/// Whether the decrease that the slope promises outweighs the violation (switching condition, eq. 19).
bool promises_decrease(const SearchPoint& start, double alpha)
{
  return start.slope < 0.0 && alpha * std::pow(-start.slope, 2.3) > std::pow(start.violation, 1.1);
}

}  // namespace

void Filter::reset(double violation)
{
  clear();
  greatest_violation_ = 4.0 * std::max(1.0, violation);
  small_violation_ = 1e-4 * std::max(1.0, violation);
}

void Filter::add(double violation, double barrier)
{
  entries_.push_back({(1.0 - kViolationMargin) * violation, barrier - kBarrierMargin * violation});
}

bool Filter::accepts(double violation, double barrier) const
{
  return violation <= greatest_violation_ && std::none_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
           return violation >= entry.violation && barrier >= entry.barrier;
         });
}

Filter::Verdict Filter::judge(const SearchPoint& start, double alpha, double violation, double barrier) const
{
  if (!std::isfinite(violation) || !std::isfinite(barrier) || !accepts(violation, barrier)) return Verdict::rejected;
  const double change = barrier - start.barrier - rounding(start.barrier);
  if (start.violation <= small_violation_ && promises_decrease(start, alpha))
    return change <= kArmijo * alpha * start.slope ? Verdict::reduces_barrier : Verdict::rejected;
  const bool progress =
      violation <= (1.0 - kViolationMargin) * start.violation || change <= -kBarrierMargin * start.violation;
  return progress ? Verdict::makes_progress : Verdict::rejected;
}

}  // namespace fourwis::ocp
