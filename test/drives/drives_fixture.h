#pragma once

#include <gtest/gtest.h>

#include "../support/bus_recorder.h"
#include "can/bus/memory_bus.h"
#include "fourwis_navigation/drives/fake_drives.h"
#include "raw_master.h"

namespace fourwis::drives
{

/// Counts of a turn of a steering column and of a wheel of 0.1 m radius, as the default options have it.
inline constexpr double kSteeringTurn = 65536.0 * 60.0, kDrivingTurn = 65536.0 * 20.0, kWheelRadius = 0.1;
inline constexpr double kPerRadian = kSteeringTurn / (2.0 * M_PI);
inline constexpr double kPerMetre = kDrivingTurn / (2.0 * M_PI * kWheelRadius);

/// A base of eight drives and a master at the two ends of a bus, a listener, and one clock for all.
class DrivesFixture : public ::testing::Test
{
protected:
  explicit DrivesFixture(const can::MemoryBusOptions& bus = {}, const can::BridgeOptions& base = {})
    : bus_(bus),
      drives(*drives_end_, Robot(), base, SimulatorOptions())
  {}

  /// Advances the time in steps of 1 ms. In every tenth step the master sends its cycle, unless it is silent.
  void pass(double seconds)
  {
    const auto steps = static_cast<long>(seconds * 1e3 + 0.5);
    for (long k = 0; k < steps; ++k)
    {
      if (++ticks % 10 == 0 && speaks) master.cycle(controlword);
      bus_.advance(static_cast<double>(ticks) * 1e-3);
      drives.step();
      recorder.poll(drives.time());
      for (can::Frame frame; master.end().receive(frame) == can::BusStatus::ok;) heard.push_back(frame);
    }
  }

  /// Boots, sets all drives up and makes them operational.
  void configure()
  {
    pass(0.15);
    for (int node = 1; node <= 8; ++node)
      for (const can::Frame& request : RawMaster::configuration(node))
      {
        heard.clear();
        master.end().send(request);
        pass(0.003);
        const auto answer =
            std::find_if(heard.begin(), heard.end(), [](const can::Frame& frame) { return frame.id >> 7 == 0xB; });
        ASSERT_NE(answer, heard.end()) << can::text(request);
        ASSERT_EQ(answer->data[0], 0x60) << can::text(request) << " -> " << can::text(*answer);
      }
    master.end().send(raw(0x000, {1, 0}));
    speaks = true;
  }

  void enable()
  {
    for (int word : {0x06, 0x07, 0x0F})
    {
      controlword = word;
      pass(0.02);
    }
    for (int node = 1; node <= 8; ++node) ASSERT_EQ(drives.drive(node).power_state(), PowerState::operation_enabled);
  }

  /// Set up, enabled, rolling straight ahead at `speed` [m/s].
  void drive_at(double speed)
  {
    configure();
    enable();
    for (std::size_t k = 4; k < 8; ++k) master.target[k] = speed * kPerMetre;
    pass(0.5);
    ASSERT_NEAR(drives.twist().vx, speed, 1e-3);
  }

  /// Turns the wheels at 2 rad/s: a jump would be a following error.
  void steer_to(const std::array<double, 4>& angles)
  {
    for (bool there = false; !there; pass(0.01))
    {
      there = true;
      for (std::size_t k = 0; k < 4; ++k)
      {
        const double left = angles[k] * kPerRadian - master.target[k], step = 0.02 * kPerRadian;
        master.target[k] += std::clamp(left, -step, step);
        there = there && std::abs(left) <= step;
      }
    }
    pass(0.3);
  }

  double fastest_wheel() const
  {
    double fastest = 0.0;
    for (double speed : drives.truth().speed) fastest = std::max(fastest, std::abs(speed));
    return fastest;
  }

private:
  can::MemoryBus bus_;
  std::unique_ptr<can::Bus> drives_end_ = bus_.open(), master_end_ = bus_.open(), listener_end_ = bus_.open();

protected:
  FakeDrives drives;
  RawMaster master{*master_end_};
  BusRecorder recorder{*listener_end_};
  bool speaks = false;
  int controlword = 0x00;
  long ticks = 0;
  Frames heard;
};

}  // namespace fourwis::drives
