#include "link_watch.h"

namespace fourwis::can
{

void LinkWatch::set_up(bool up, double now)
{
  if (up_ && !up) log_.report(Fault::link_down, kNoAxis, 0, now);
  if (!up_ && up) notice_.bus_off = heard_ = false;
  up_ = up;
}

void LinkWatch::receive(const Frame& frame, double now)
{
  if (const auto notice = decode_notice(frame)) return take(*notice, now);
  heard_ = true;
  notice_.bus_off = false;  // a controller that receives frames is on the bus
}

void LinkWatch::supervise(const Outbox& outbox, double now)
{
  const bool stuck = usable() && heard_ && !outbox.empty() && outbox.sent() == sent_;
  sent_ = outbox.sent();
  if (blocked_.update(stuck, now)) log_.report(Fault::transmit_timeout, kNoAxis, 0, now);
}

void LinkWatch::take(const ControllerNotice& notice, double now)
{
  if (notice.bus_off && !notice_.bus_off) log_.report(Fault::bus_off, kNoAxis, 0, now);
  if (tells_state(notice)) notice_ = notice;
  if (notice.transmit_timeout) log_.report(Fault::transmit_timeout, kNoAxis, 0, now);
  if (notice.passive) log_.report(Fault::error_passive, kNoAxis, 0, now);
  if (notice.receive_overflow) log_.report(Fault::receive_overflow, kNoAxis, 0, now);
}

}  // namespace fourwis::can
