#include "stop_procedure.h"

#include <algorithm>

namespace fourwis::can
{

void StopProcedure::begin(Kind kind, double now)
{
  if (kind_ == Kind::none)
  {
    phase_ = Phase::braking;
    begun_ = now;
    standstill_.reset();
  }
  kind_ = std::max(kind_, kind);
}

void StopProcedure::cancel()
{
  kind_ = Kind::none;
  phase_ = Phase::idle;
}

void StopProcedure::update(double measured, double commanded, bool off, double now)
{
  const bool stands = standstill_.update(std::max(measured, commanded) <= speed_, now);
  if (phase_ == Phase::braking && (stands || now - begun_ > timeout_ || off)) phase_ = Phase::releasing;
  if (phase_ == Phase::releasing && off) phase_ = Phase::done;
}

}  // namespace fourwis::can
