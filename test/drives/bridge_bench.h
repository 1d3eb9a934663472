#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../support/bus_recorder.h"
#include "can/bridge/bridge_connection.h"
#include "fourwis_navigation/drives/fake_drives.h"

namespace fourwis
{

/// The bridge's end of the bus. It records what the bridge sends.
class SpiedBus final : public can::Bus
{
public:
  explicit SpiedBus(can::Bus& bus) : bus_(bus) {}

  can::BusStatus send(const can::Frame& frame) override
  {
    const can::BusStatus status = bus_.send(frame);
    if (status == can::BusStatus::ok) sent.push_back({now, frame});
    return status;
  }
  can::BusStatus receive(can::Frame& frame) override { return bus_.receive(frame); }
  int descriptor() const override { return bus_.descriptor(); }
  bool recover() override { return bus_.recover(); }
  can::BusCounters counters() const override { return bus_.counters(); }
  std::string_view last_error() const override { return bus_.last_error(); }

  std::vector<RecordedFrame> sent;
  double now = 0.0;

private:
  can::Bus& bus_;
};

/// Operation enabled and a target that is not zero, for one of the driving drives 5 to 8.
inline bool tells_to_move(const can::Frame& frame)
{
  const bool is_command = frame.id >= 0x205 && frame.id <= 0x208 && frame.size == 7;
  return is_command && (frame.data[0] & 0x0F) == 0x0F &&
         (frame.data[3] | frame.data[4] | frame.data[5] | frame.data[6]) != 0;
}

/// A bridge and eight fake drives at the two ends of a bus, a commander with a period of 20 ms, and one clock for all:
/// nothing here is measured with a real one.
class BridgeBench
{
public:
  /// `pass_on` gives the bus the time [s]. The bridge is constructed with the options `expected`, the drives with
  /// `real`.
  BridgeBench(can::Bus& bridge_end, can::Bus& drives_end, std::function<void(double)> pass_on,
              const can::BridgeOptions& expected = {}, const can::BridgeOptions& real = {})
    : options(expected),
      spy(bridge_end),
      drives(drives_end, robot, real, SimulatorOptions()),
      pass_on_(std::move(pass_on))
  {}
  virtual ~BridgeBench() = default;

  /// Lets time pass in steps of 1 ms.
  void pass(double seconds)
  {
    for (auto left = std::lround(seconds * 1e3); left > 0; --left) tick();
  }

  /// Advances the time until the condition holds. Returns the time that took, or infinity if it was longer than `most`
  /// [s].
  double wait_for(const std::function<bool()>& condition, double most = 60.0)
  {
    const double begin = now();
    while (!condition())
    {
      if (now() - begin > most) return std::numeric_limits<double>::infinity();
      tick();
    }
    return now() - begin;
  }

  double wait_for(can::BridgeStage stage, double most = 60.0)
  {
    return wait_for([&] { return this->stage() == stage; }, most);
  }

  void enable()
  {
    ASSERT_LT(wait_for(can::BridgeStage::ready), 5.0) << cause();
    ASSERT_EQ(bridge.enable(now()), nullptr);
    ASSERT_LT(wait_for(can::BridgeStage::enabled), 5.0) << cause();
  }

  /// Sets the motion that is commanded from now on.
  void command(Mode mode, double angle, double speed)
  {
    commands = true;
    wanted.mode = mode;
    wanted.motion.angle.fill(angle);
    wanted.motion.speed.fill(speed);
  }

  /// Straight ahead at 0.5 m/s.
  void drive()
  {
    if (stage() != can::BridgeStage::enabled) enable();
    command(Mode::ackermann, 0.0, 0.5);
    ASSERT_LT(wait_for([&] { return std::abs(drives.twist().vx - 0.5) < 0.01; }), 2.0) << cause();
  }

  double now() const { return static_cast<double>(ticks_) * 1e-3; }
  can::BridgeStage stage() const { return bridge.report().stage; }
  std::string cause() const { return text_of(bridge.report().cause); }
  bool told(can::Fault fault) const
  {
    const auto& history = bridge.report().history;
    return std::any_of(history.begin(), history.end(), [&](const can::FaultRecord& r) { return r.fault == fault; });
  }
  double fastest_wheel() const
  {
    double fastest = 0.0;
    for (const double speed : drives.truth().speed) fastest = std::max(fastest, std::abs(speed));
    return fastest;
  }

  /// When the bridge commanded a driving drive to move for the last time [s]; minus infinity if never.
  double last_motion() const
  {
    const auto last = std::find_if(spy.sent.rbegin(), spy.sent.rend(),
                                   [](const RecordedFrame& recorded) { return tells_to_move(recorded.frame); });
    return last == spy.sent.rend() ? -std::numeric_limits<double>::infinity() : last->time;
  }

  void tick()
  {
    ++ticks_;
    spy.now = now();
    pass_on_(now());
    if (bridge_alive) run_bridge();
    drives.step();
  }

  void send(const WheelCommand& command)
  {
    bridge.command(command, now(), now());
    connection.flush(now());
  }

  virtual void run_bridge()
  {
    if (commands && ticks_ % 20 == 7)
    {
      ++wanted.sequence;
      send(wanted);
    }
    connection.exchange(now());
    if (ticks_ % 10 == 0) connection.cycle(now());
  }

  const Robot robot;
  const can::BridgeOptions options;
  SpiedBus spy;
  drives::FakeDrives drives;
  can::Bridge bridge{robot, options};
  can::BridgeConnection connection{bridge, spy};
  bool bridge_alive = true;  ///< otherwise it neither receives nor sends, like a killed process
  bool commands = false;
  WheelCommand wanted;

private:
  std::function<void(double)> pass_on_;
  long ticks_ = 0;
};

}  // namespace fourwis
