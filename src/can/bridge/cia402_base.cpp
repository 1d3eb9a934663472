#include "cia402_base.h"

#include <algorithm>
#include <limits>

namespace fourwis::can
{
namespace
{

/// Least time of listening before anything is sent: two cycles of a slow master [s].
constexpr double kShortestListening = 0.1;

}  // namespace

Cia402Base::Cia402Base(const Robot& robot, const BridgeOptions& options, FaultLog& log)
  : master_(options.master_node),
    heartbeat_period_(options.heartbeat_period),
    listen_time_(std::max(kShortestListening, options.drive_watchdog)),
    report_(log, kNoAxis),
    heartbeat_sent_(-std::numeric_limits<double>::infinity())
{
  axis_of_node_.fill(kNoAxis);
  axes_.reserve(kAxes);
  for (int i = 0; i < kAxes; ++i)
  {
    axes_.emplace_back(robot, options, i, log);
    axis_of_node_.at(static_cast<std::size_t>(axes_.back().node())) = i;
  }
}

void Cia402Base::restart(bool reset_faults, double now, Outbox& outbox)
{
  if (ran_before_) stop(outbox);
  reset_faults_ = reset_faults;
  listening_ = true;
  foreign_ = false;
  listen_until_ = now + listen_time_;
}

/// It takes effect with the SYNC.
void Cia402Base::stop(Outbox& outbox) const
{
  for (std::size_t i = kWheels; i < kAxes; ++i) axes_[i].stop(outbox);
  outbox.put(encode_sync());
}

void Cia402Base::receive(const Frame& frame, double now, Outbox& outbox)
{
  const Address address = address_of(frame);
  if (is_masters(address))
  {
    foreign_ = true;
    report_(Fault::foreign_master, frame.id, now);
  }
  const int axis = axis_of_node_[static_cast<std::size_t>(address.node)];
  if (axis == kNoAxis || listening_) return;
  axes_[static_cast<std::size_t>(axis)].receive(address.service, frame, now, outbox);
  measure();
}

void Cia402Base::supervise(double now, Outbox& outbox)
{
  if (listening_ && (foreign_ || now < listen_until_)) return;
  if (listening_)
  {
    listening_ = false;
    ran_before_ = true;
    for (Axis& axis : axes_) axis.restart(reset_faults_, now, outbox);
  }
  for (Axis& axis : axes_) axis.supervise(now, outbox);
}

void Cia402Base::command(const DriveDemand& demand, double now, Outbox& outbox)
{
  if (listening_) return;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    axes_[i].command(demand.steering, demand.motion.angle[i], now, outbox);
    axes_[kWheels + i].command(demand.driving, demand.motion.speed[i], now, outbox);
  }
}

void Cia402Base::end_cycle(double now, Outbox& outbox)
{
  if (listening_) return;
  // A millisecond of slack, because cycles do not begin exactly on time.
  if (now - heartbeat_sent_ > heartbeat_period_ - 1e-3)
  {
    heartbeat_sent_ = now;
    outbox.put(encode_heartbeat(master_, NmtState::operational));
  }
  outbox.put(encode_sync());
  for (Axis& axis : axes_) axis.sync_sent(now);
}

StartStep Cia402Base::step() const
{
  if (listening_) return StartStep::listening;
  StartStep least = StartStep::started;
  for (const Axis& axis : axes_) least = std::min(least, axis.step());
  return least;
}

double Cia402Base::measured_at() const
{
  double oldest = std::numeric_limits<double>::infinity();
  for (const Axis& axis : axes_) oldest = std::min(oldest, axis.measured_at());
  return oldest;
}

int Cia402Base::first_able_to_move() const
{
  return first_axis([](const Axis& axis) { return !axis.out_of_operation(); });
}

int Cia402Base::first_not_following() const
{
  return first_axis([](const Axis& axis) { return !axis.in_operation(); });
}

int Cia402Base::first_axis(bool (*is_it)(const Axis&)) const
{
  const auto found = std::find_if(axes_.begin(), axes_.end(), is_it);
  return found == axes_.end() ? kNoAxis : static_cast<int>(found - axes_.begin());
}

/// Whether only the master of these drives sends such a message. A received one comes from another master, because our
/// own frames do not come back to us.
bool Cia402Base::is_masters(const Address& address) const
{
  switch (address.service)
  {
    case Service::nmt:
    case Service::sync: return true;
    case Service::heartbeat: return address.node == master_;
    case Service::rpdo1:
    case Service::rpdo2:
    case Service::rpdo3:
    case Service::rpdo4:
    case Service::sdo_request: return axis_of_node_[static_cast<std::size_t>(address.node)] != kNoAxis;
    default: return false;
  }
}

void Cia402Base::measure()
{
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    measured_.angle[i] = axes_[i].position();
    measured_.speed[i] = axes_[kWheels + i].speed();
  }
}

}  // namespace fourwis::can
