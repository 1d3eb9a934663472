#include "can_latency.h"

#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <random>
#include <stdexcept>
#include <thread>

#include "fourwis_navigation/can/bridge.h"
#include "fourwis_navigation/can/bridge_connection.h"
#include "fourwis_navigation/can/bus.h"
#include "fourwis_navigation/can/mailbox.h"
#include "fourwis_navigation/sim/fake_drives.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis::benchmark
{
namespace
{

using can::BridgeStage;

/// The drives come second: a real base does not wait for this machine.
constexpr int kBridgePriority = 50, kDrivesPriority = 49;
constexpr int kMicrosecondsBetweenCommands = 20000;

/// Seconds of the monotonic clock.
double seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Whether this thread may from here on go before all that are not real-time.
bool become_real_time(int priority)
{
  const sched_param parameters{priority};
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

struct StampedCommand
{
  WheelCommand command;
  double stamp = 0.0;  ///< when the callback had it
};

/// The fake drives at their end of the bus, in real time.
class DrivesThread
{
public:
  explicit DrivesThread(const std::string& name)
    : bus_(can::open_bus(name)), drives_(*bus_, Robot(), can::BridgeOptions(), SimulatorOptions()),
      thread_([this] { run(); })
  {
  }
  ~DrivesThread()
  {
    done_ = true;
    thread_.join();
  }

private:
  void run()
  {
    become_real_time(kDrivesPriority);
    for (double before = seconds(); !done_;)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      const double now = seconds();
      drives_.advance(now - before);
      before = now;
    }
  }

  std::unique_ptr<can::Bus> bus_;
  sim::FakeDrives drives_;
  std::atomic<bool> done_{false};
  std::thread thread_;
};

/// The bridge at its end: woken by frames, by commands, and by its cycle.
class BridgeThread
{
public:
  BridgeThread(const std::string& name, CanLatency& latency)
    : latency_(latency), bus_(can::open_bus(name)), bridge_(Robot(), options_), connection_(bridge_, *bus_),
      wake_(eventfd(0, EFD_NONBLOCK)),
      thread_([this] { run(); })
  {
  }
  ~BridgeThread()
  {
    done_ = true;
    thread_.join();
    close(wake_);
  }

  /// As of the last cycle.
  const can::BridgeReport& report()
  {
    reports_.take(report_);
    return report_;
  }

  /// What a callback does.
  void command(const WheelCommand& command)
  {
    mailbox_.put({command, seconds()});
    eventfd_write(wake_, 1);
  }

private:
  void run()
  {
    latency_.real_time = become_real_time(kBridgePriority);
    for (double next_cycle = seconds(); !done_;)
    {
      wait_until(next_cycle);
      connection_.exchange(seconds());
      take_command();
      if (seconds() < next_cycle) continue;
      next_cycle += options_.cycle_time;
      cycle();
    }
  }

  void wait_until(double time)
  {
    pollfd events[] = {{bus_->descriptor(), POLLIN, 0}, {wake_, POLLIN, 0}};
    const double left = std::max(0.0, time - seconds());
    const timespec timeout{0, static_cast<long>(left * 1e9)};
    ppoll(events, 2, &timeout, nullptr);
    eventfd_t count;
    eventfd_read(wake_, &count);
  }

  void take_command()
  {
    StampedCommand newest;
    if (!mailbox_.take(newest)) return;
    const std::uint64_t before = bridge_.outbox().sent();
    bridge_.command(newest.command, seconds());
    connection_.flush(seconds());
    if (connection_.is_blocked()) return;
    latency_.microseconds.push_back(1e6 * (seconds() - newest.stamp));
    latency_.frames.push_back(static_cast<double>(bridge_.outbox().sent() - before));
  }

  void cycle()
  {
    const can::BridgeReport report = bridge_.report();
    if (report.stage == BridgeStage::ready) bridge_.enable(seconds());
    reports_.put(report);
    connection_.cycle(seconds());
  }

  CanLatency& latency_;
  const can::BridgeOptions options_;
  std::unique_ptr<can::Bus> bus_;
  can::Bridge bridge_;
  can::BridgeConnection connection_;
  can::Mailbox<StampedCommand> mailbox_;
  int wake_;
  can::Mailbox<can::BridgeReport> reports_;
  can::BridgeReport report_;
  std::atomic<bool> done_{false};
  std::thread thread_;
};

void expect_enabled(const can::BridgeReport& report)
{
  if (report.stage == BridgeStage::enabled) return;
  throw std::runtime_error(std::string("the bridge is in ") + to_string(report.stage) + ' ' + text_of(report.cause));
}

void wait_until_enabled(BridgeThread& bridge)
{
  for (const double end = seconds() + 30.0; bridge.report().stage != BridgeStage::enabled && seconds() < end;)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  expect_enabled(bridge.report());
}

}  // namespace

CanLatency measure_can_latency(const std::string& name, int commands)
{
  CanLatency latency;
  latency.microseconds.reserve(static_cast<std::size_t>(commands));
  latency.frames.reserve(static_cast<std::size_t>(commands));
  const DrivesThread drives(name);
  BridgeThread bridge(name, latency);
  wait_until_enabled(bridge);
  std::mt19937 random(1);
  WheelCommand command;
  command.mode = Mode::ackermann;
  command.motion = wheel_motion(Robot(), Mode::ackermann, 0.5, 0.0);
  for (; command.sequence < static_cast<std::uint32_t>(commands); ++command.sequence)
  {
    // Anywhere in the bridge's cycle.
    std::this_thread::sleep_for(std::chrono::microseconds(kMicrosecondsBetweenCommands - 5000 + random() % 10000));
    bridge.command(command);
  }
  expect_enabled(bridge.report());
  return latency;
}

}  // namespace fourwis::benchmark
