#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "fourwis_navigation/can/bridge.h"
#include "fourwis_navigation/can/bus.h"
#include "fourwis_navigation/sim/fake_drives.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis
{

/// The bridge and the fake drives at two ends of a bus, in simulated time: whatever the bus, the machine's speed does not
/// matter.
class DrivenBase
{
public:
  using Clock = std::function<void(double)>;

  /// `bus_clock` is told the time [s] where the bus wants to know it.
  DrivenBase(can::Bus& master, can::Bus& others, const Robot& robot, const can::BridgeOptions& options,
             const SimulatorOptions& simulator, Clock bus_clock = [](double) {})
    : bus_(master), options_(options), simulator_(simulator), bridge_(robot, options),
      drives_(others, robot, options, simulator), bus_clock_(std::move(bus_clock))
  {
  }

  can::Bridge& bridge() { return bridge_; }
  sim::FakeDrives& drives() { return drives_; }
  const sim::FakeDrives& drives() const { return drives_; }
  double now() const { return now_; }

  /// What the bridge does, and why not more; for messages.
  std::string state() const
  {
    const can::BridgeReport report = bridge_.report();
    return std::string(to_string(report.stage)) + " (" + text_of(report.cause) + ")";
  }

  /// Repeats this command from here on.
  void drive(const WheelMotion& motion, Mode mode = Mode::ackermann)
  {
    command_.mode = mode;
    command_.motion = motion;
    commanded_ = true;
  }
  void fall_silent() { commanded_ = false; }

  /// Whether `condition` holds within so long [s]; then at once.
  template <class Condition>
  bool reach(double within, Condition condition)
  {
    for (const double last = now_ + within - 0.5 * simulator_.time_step; !condition(); step())
      if (now_ > last) return false;
    return true;
  }
  bool become(BaseState state, double within)
  {
    return reach(within, [&] { return bridge_.wheels().state == state; });
  }
  void advance(double duration)
  {
    reach(duration, [] { return false; });
  }

private:
  void step()
  {
    now_ = ++steps_ * simulator_.time_step;
    bus_clock_(now_);
    drives_.step();
    take();
    if (commanded_ && is_due(next_command_, kCommandPeriod))
    {
      ++command_.sequence;
      bridge_.command(command_, now_);
    }
    if (is_due(next_cycle_, options_.cycle_time))
    {
      if (!up_) set_link(bus_.recover());
      bridge_.cycle(now_);
    }
    send();
  }

  void take()
  {
    can::Frame frame;
    can::BusStatus status = can::BusStatus::ok;
    while (up_ && (status = bus_.receive(frame)) == can::BusStatus::ok) bridge_.receive(frame, now_);
    if (up_ && status == can::BusStatus::down) set_link(false);
  }

  void send()
  {
    if (up_ && bridge_.outbox().flush(bus_) == can::BusStatus::down) set_link(false);
  }

  void set_link(bool up)
  {
    up_ = up;
    bridge_.set_link(up, now_);
  }

  bool is_due(double& next, double period) const
  {
    if (now_ < next - 1e-9) return false;
    next += period;
    return true;
  }

  /// Commands come at 50 Hz, not when the bridge's cycle begins [s].
  static constexpr double kCommandPeriod = 0.02, kCommandPhase = 0.003;

  can::Bus& bus_;
  can::BridgeOptions options_;
  SimulatorOptions simulator_;
  can::Bridge bridge_;
  sim::FakeDrives drives_;
  Clock bus_clock_;
  WheelCommand command_;
  double now_ = 0.0, next_cycle_ = 0.0, next_command_ = kCommandPhase;
  long steps_ = 0;
  bool commanded_ = false, up_ = false;
};

}  // namespace fourwis
