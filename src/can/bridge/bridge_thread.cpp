#include "fourwis_navigation/can/bridge/bridge_thread.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <thread>
#include <utility>

#include "bridge_connection.h"
#include "fourwis_navigation/can/bus/mailbox.h"
#include "fourwis_navigation/can/bus/real_time.h"
#include "fourwis_navigation/can/bus/request_slot.h"
#include "fourwis_navigation/model/option_range.h"
#include "stop_button.h"

namespace fourwis::can
{
namespace
{

/// When the bus has no room for waiting frames, sending is tried again after this time [s].
constexpr double kRetryPeriod = 1e-3;

/// Waits until one of two descriptors becomes readable, or until the timeout [s]. A descriptor of -1 never does.
void wait_for(int bus, int wake, double timeout)
{
  pollfd items[] = {{bus, POLLIN, 0}, {wake, POLLIN, 0}};
  timespec most{};
  most.tv_nsec = static_cast<long>(std::fmod(timeout, 1.0) * 1e9);
  most.tv_sec = static_cast<time_t>(timeout);
  ppoll(items, 2, &most, nullptr);
}

struct TimedCommand
{
  WheelCommand command;
  double made = 0.0, given = 0.0;  ///< [s]
};

}  // namespace

class BridgeThread::Implementation
{
public:
  Implementation(const Robot& robot, const BridgeOptions& options, std::unique_ptr<Bus> bus, int priority)
    : cycle_time_(options.cycle_time),
      bus_(std::move(bus)),
      bridge_(robot, options),
      connection_(bridge_, *bus_)
  {
    require_in({0.0, kHighestPriority, "", true}, "priority", priority);
    // The promise belongs to the thread: nothing that both use ends with this constructor.
    std::promise<std::string> promise;
    std::future<std::string> complaint = promise.get_future();
    thread_ = std::thread([this, priority, promise = std::move(promise)]() mutable {
      promise.set_value(priority > 0 ? become_real_time(priority) : "");
      run();
    });
    complaint_ = complaint.get();
  }

  ~Implementation()
  {
    end_ = true;
    wake_.raise();
    thread_.join();
  }

  const std::string& complaint() const { return complaint_; }

  void command(const WheelCommand& command, double age)
  {
    const double now = monotonic_now();
    commands_.put({command, now - age, now});
    wake_.raise();
  }

  void press_emergency_stop(bool pressed)
  {
    emergency_stop_.set(pressed);
    wake_.raise();
  }

  std::string ask(RequestSlot::Request request) { return requests_.ask(request); }

  bool wait(BridgeUpdate& update, double timeout)
  {
    const double end = monotonic_now() + timeout;
    // The event may still be raised for an update that has been taken.
    for (bool taken = updates_.take(update); !taken; taken = updates_.take(update))
      if (!updated_.wait(end - monotonic_now())) return false;
    return true;
  }

private:
  void run()
  {
    double next = monotonic_now();
    while (!end_)
    {
      const double left = next - monotonic_now();
      const double most = connection_.is_blocked() ? std::min(left, kRetryPeriod) : left;
      if (left > 0.0) wait_for(bus_->descriptor(), wake_.descriptor(), most);
      take_requests();
      connection_.exchange(monotonic_now());
      if (monotonic_now() >= next) next = cycle(next);
    }
  }

  /// Carries out what other threads have requested since the last call.
  void take_requests()
  {
    wake_.clear();
    const double now = monotonic_now();
    emergency_stop_.pass_on([&](bool pressed) { bridge_.press_emergency_stop(pressed, now); });
    answer(now);
    TimedCommand timed;
    if (!commands_.take(timed)) return connection_.flush(now);
    bridge_.command(timed.command, timed.made, now);
    connection_.flush(now);
    const bool sent = bridge_.wheels().state == BaseState::enabled && !connection_.is_blocked();
    if (sent) update_.delays.add(monotonic_now() - timed.given);
  }

  void answer(double now)
  {
    switch (requests_.take())
    {
      case RequestSlot::Request::none: return;
      case RequestSlot::Request::enable: return requests_.answer(bridge_.enable(now));
      case RequestSlot::Request::disable: return requests_.answer(bridge_.disable(now));
      case RequestSlot::Request::clear_faults: return requests_.answer(bridge_.clear_faults(now));
    }
  }

  /// When the next cycle is due.
  double cycle(double due)
  {
    const double now = monotonic_now();
    connection_.cycle(now);
    update_.latest_cycle = std::max(update_.latest_cycle, now - due);
    ++update_.cycles;
    publish(now);
    const double missed = std::floor((now - due) / cycle_time_);
    update_.overruns += static_cast<std::uint64_t>(missed);
    return due + (missed + 1.0) * cycle_time_;
  }

  void publish(double now)
  {
    update_.time = now;
    update_.wheels = bridge_.wheels();
    update_.report = bridge_.report();
    update_.bus = bus_->counters();
    const bool down = update_.report.stage == BridgeStage::link_down;
    const std::string_view error = down ? bus_->last_error() : "";
    update_.bus_error[error.copy(update_.bus_error.data(), update_.bus_error.size() - 1)] = '\0';
    updates_.put(update_);
    updated_.raise();
  }

  const double cycle_time_;
  std::unique_ptr<Bus> bus_;
  Bridge bridge_;
  BridgeConnection connection_;
  BridgeUpdate update_;

  SignalEvent wake_, updated_;
  Mailbox<TimedCommand> commands_;
  Mailbox<BridgeUpdate> updates_;
  RequestSlot requests_{wake_};
  StopButton emergency_stop_;
  std::atomic<bool> end_{false};
  std::string complaint_;
  std::thread thread_;  ///< last: it uses all of the above
};

BridgeThread::BridgeThread(const Robot& robot, const BridgeOptions& options, std::unique_ptr<Bus> bus, int priority)
  : implementation_(std::make_unique<Implementation>(robot, options, std::move(bus), priority))
{}
BridgeThread::~BridgeThread() = default;

std::string BridgeThread::complaint() const
{
  return implementation_->complaint();
}
void BridgeThread::command(const WheelCommand& command, double age)
{
  implementation_->command(command, age);
}
void BridgeThread::press_emergency_stop(bool pressed)
{
  implementation_->press_emergency_stop(pressed);
}
std::string BridgeThread::enable()
{
  return implementation_->ask(RequestSlot::Request::enable);
}
std::string BridgeThread::disable()
{
  return implementation_->ask(RequestSlot::Request::disable);
}
std::string BridgeThread::clear_faults()
{
  return implementation_->ask(RequestSlot::Request::clear_faults);
}
bool BridgeThread::wait(BridgeUpdate& update, double timeout)
{
  return implementation_->wait(update, timeout);
}

}  // namespace fourwis::can
