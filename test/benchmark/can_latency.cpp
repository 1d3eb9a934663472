#include "can_latency.h"

#include <chrono>
#include <stdexcept>
#include <thread>

#include "../drives/real_time_drives.h"
#include "../support/random.h"
#include "fourwis_navigation/can/bridge/bridge_thread.h"
#include "fourwis_navigation/can/bus/real_time.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis::benchmark
{
namespace
{

using can::BridgeStage;

/// The drives come second: real ones do not wait for this machine.
constexpr int kBridgePriority = 50, kDrivesPriority = 49;
/// The base has so long to start [s].
constexpr double kPatience = 30.0;

can::BridgeUpdate next_update(can::BridgeThread& bridge)
{
  can::BridgeUpdate update;
  if (!bridge.wait(update, kPatience)) throw std::runtime_error("the bridge's thread does not run");
  return update;
}

void expect_enabled(const can::BridgeReport& report)
{
  if (report.stage == BridgeStage::enabled) return;
  throw std::runtime_error(std::string("the bridge is in ") + to_string(report.stage) + ' ' + text_of(report.cause));
}

void enable(can::BridgeThread& bridge)
{
  can::BridgeReport report;
  for (const double end = can::monotonic_now() + kPatience; can::monotonic_now() < end;)
  {
    report = next_update(bridge).report;
    if (report.stage == BridgeStage::ready) bridge.enable();
    if (report.stage == BridgeStage::enabled) break;
  }
  expect_enabled(report);
}

/// A little more or less than 20 ms: anywhere in the bridge's cycle.
void wait_for_next_command(Random& random)
{
  std::this_thread::sleep_for(std::chrono::microseconds(random.whole(15000, 25000)));
}

}  // namespace

CanLatency measure_can_latency(const std::string& name, int commands)
{
  const RealTimeDrives drives(name, kDrivesPriority);
  can::BridgeThread bridge(Robot(), can::BridgeOptions(), can::open_bus(name), kBridgePriority);
  enable(bridge);
  Random random(1);
  WheelCommand command;
  command.mode = Mode::ackermann;
  command.motion = wheel_motion(Robot(), Mode::ackermann, 0.5, 0.0);
  for (int sent = 0; sent < commands; ++sent)
  {
    wait_for_next_command(random);
    ++command.sequence;
    bridge.command(command);
  }
  next_update(bridge);  // of the last cycle before, perhaps
  const can::BridgeUpdate last = next_update(bridge);
  expect_enabled(last.report);
  return {last.delays, bridge.complaint().empty()};
}

}  // namespace fourwis::benchmark
