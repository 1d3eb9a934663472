#pragma once

#include <array>
#include <memory>
#include <string>

#include "fourwis_navigation/can/bridge/bridge.h"
#include "fourwis_navigation/can/bridge/delay_statistics.h"
#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{

/// The state of the bridge after a cycle.
struct BridgeUpdate
{
  double time = 0.0;  ///< of the cycle, monotonic_now() [s]
  WheelState wheels;
  BridgeReport report;
  BusCounters bus;
  std::array<char, 128> bus_error{};  ///< error text of the bus while it is down
  DelayStatistics delays;             ///< from command() until the bus has taken its frames
  std::uint64_t cycles = 0;
  std::uint64_t overruns = 0;  ///< cycles left out because the thread did not run in time
  double latest_cycle = 0.0;   ///< the greatest delay of a cycle's beginning so far [s]
};

/// Runs a bridge on a bus in a thread of its own. No other thread can make it wait.
class BridgeThread
{
public:
  /// Starts at once. `priority`: see become_real_time(); 0: an ordinary thread. Throws as Bridge does, and
  /// std::invalid_argument for a priority that does not exist.
  BridgeThread(const Robot& robot, const BridgeOptions& options, std::unique_ptr<Bus> bus, int priority);

  /// Ends at once, even while the wheels move: call disable() and wait first. Otherwise the drives' own watchdogs stop
  /// them.
  ~BridgeThread();

  /// What the system did not allow, see become_real_time().
  std::string complaint() const;

  // From one thread at a time; none of them waits.
  void command(const WheelCommand& command, double age = 0.0);  ///< `age`: since it was made [s]
  void press_emergency_stop(bool pressed);                      ///< each press stops the base, even a very short one

  // Requests of the operator, from any thread. Each waits for the bridge's answer, which is empty when it is accepted.
  std::string enable();
  std::string disable();
  std::string clear_faults();

  /// Waits for the update of the next cycle, at most `timeout` [s]; false if none came. To be called by one thread
  /// only.
  bool wait(BridgeUpdate& update, double timeout);

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fourwis::can
