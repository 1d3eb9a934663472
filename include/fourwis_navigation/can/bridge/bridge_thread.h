#pragma once

#include <array>
#include <memory>
#include <string>

#include "fourwis_navigation/can/bridge/bridge.h"
#include "fourwis_navigation/can/bridge/delay_statistics.h"
#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{

/// What the bridge says of itself after each cycle.
struct BridgeUpdate
{
  double time = 0.0;  ///< of the cycle, monotonic_now() [s]
  WheelState wheels;
  BridgeReport report;
  BusCounters bus;
  std::array<char, 128> bus_error{};  ///< what the bus says while it is down, for a person
  DelayStatistics delays;             ///< from command() until the bus has taken its frames
  std::uint64_t cycles = 0;
  std::uint64_t overruns = 0;  ///< cycles that were left out because the thread was not given the time
  double latest_cycle = 0.0;   ///< the greatest delay of a cycle's beginning so far [s]
};

/// Runs a bridge on a bus in a thread of its own, which shares nothing with others that could make it wait.
class BridgeThread
{
public:
  /// Begins at once. `priority`: see become_real_time(); 0: an ordinary thread. Throws std::invalid_argument where
  /// options contradict each other.
  BridgeThread(const Robot& robot, const BridgeOptions& options, std::unique_ptr<Bus> bus, int priority);

  /// Ends at once, whatever the wheels do: disable() and wait before. The drives' own watchdogs are the last to stop them.
  ~BridgeThread();

  /// What the system did not allow, see become_real_time().
  std::string complaint() const;

  // From one thread at a time; none of them waits.
  void command(const WheelCommand& command, double age = 0.0);  ///< `age`: since it was made [s]
  void press_emergency_stop(bool pressed);                      ///< each press stops the base, however short it is

  // What a person asks for, from any thread: waits for the bridge's answer, empty when it is accepted.
  std::string enable();
  std::string disable();
  std::string clear_faults();

  /// Waits for the next cycle's update, from one thread only. False where none came in time [s].
  bool wait(BridgeUpdate& update, double timeout);

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fourwis::can
