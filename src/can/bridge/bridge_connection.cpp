#include "bridge_connection.h"

namespace fourwis::can
{
namespace
{

/// Time between two attempts to open a bus that is down [s].
constexpr double kRecoverPeriod = 0.1;
/// Greatest number of frames that are received in one call: a flood of frames must not delay the cycle.
constexpr int kMostAtOnce = 256;

}  // namespace

void BridgeConnection::exchange(double now)
{
  receive(now);
  flush(now);
}

void BridgeConnection::cycle(double now)
{
  recover(now);
  exchange(now);
  bridge_.cycle(now);
  flush(now);
}

void BridgeConnection::flush(double now)
{
  if (up_ && bridge_.outbox().flush(bus_) == BusStatus::down) lose(now);
}

void BridgeConnection::receive(double now)
{
  if (!up_) return;
  BusStatus status = BusStatus::ok;
  Frame frame;
  for (int i = 0; i < kMostAtOnce && (status = bus_.receive(frame)) == BusStatus::ok; ++i)
  {
    bridge_.receive(frame, now);
    flush(now);
  }
  if (status == BusStatus::down) lose(now);
}

void BridgeConnection::recover(double now)
{
  if (up_ || now < next_attempt_) return;
  next_attempt_ = now + kRecoverPeriod;
  up_ = bus_.recover();
  if (up_) bridge_.set_link(true, now);
}

void BridgeConnection::lose(double now)
{
  up_ = false;
  bridge_.set_link(false, now);
}

}  // namespace fourwis::can
