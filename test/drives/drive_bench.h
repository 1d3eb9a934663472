#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include "fourwis_navigation/drives/fake_drive.h"

namespace fourwis::can
{

/// The frame as candump writes it: "185 [3] 37 02 08".
inline std::string text(const Frame& frame)
{
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%03X [%d]", frame.id, frame.size);
  std::string line = buffer;
  for (std::size_t i = 0; i < frame.size; ++i)
  {
    std::snprintf(buffer, sizeof buffer, " %02X", frame.data[i]);
    line += buffer;
  }
  return line;
}

inline void PrintTo(const Frame& frame, std::ostream* out)
{
  *out << text(frame);
}

}  // namespace fourwis::can

namespace fourwis::drives
{

inline can::Frame raw(std::uint32_t id, std::initializer_list<int> bytes)
{
  can::Frame frame;
  frame.id = id;
  for (int byte : bytes) frame.data[frame.size++] = static_cast<std::uint8_t>(byte);
  return frame;
}

using Frames = std::vector<can::Frame>;

/// One drive with node id 5, and a motor that follows its demands at once, up to a speed. Without power it stands.
class DriveBench
{
public:
  static constexpr double kStep = 0.001;  ///< [s]

  explicit DriveBench(const DriveOptions& options = node_5()) : drive(options) {}

  static DriveOptions node_5()
  {
    DriveOptions options;
    options.node = 5;
    return options;
  }

  void pass(double seconds)
  {
    const auto steps = static_cast<long>(seconds / kStep + 0.5);
    for (long k = 0; k < steps; ++k) step();
  }

  void step()
  {
    ++ticks_;
    drive.advance(time(), motor);
    for (const can::Frame& frame : drive.take_sent()) sent.push_back(frame);
    move();
  }

  /// Sends a frame to the drive and returns its immediate answers.
  Frames send(const can::Frame& frame)
  {
    drive.receive(time(), frame);
    const Frames answers = drive.take_sent();
    sent.insert(sent.end(), answers.begin(), answers.end());
    return answers;
  }

  /// SDO download of `size` bytes. Returns the abort code, 0 if it is accepted.
  std::uint32_t write(std::uint16_t index, int sub, int size, std::int64_t value)
  {
    const int command = 0x23 | (4 - size) << 2;
    can::Frame request = raw(0x605, {command, index & 0xFF, index >> 8, sub, 0, 0, 0, 0});
    for (int k = 0; k < size; ++k)
      request.data[static_cast<std::size_t>(4 + k)] = static_cast<std::uint8_t>(value >> 8 * k);
    const Frames answers = send(request);
    if (answers.empty()) return 0xFFFFFFFF;
    const can::Frame& answer = answers.back();
    return answer.data[0] == 0x60 ? 0 : number(answer);
  }

  /// SDO upload.
  std::uint32_t read(std::uint16_t index, int sub = 0)
  {
    const Frames answers = send(raw(0x605, {0x40, index & 0xFF, index >> 8, sub, 0, 0, 0, 0}));
    return answers.empty() ? 0xFFFFFFFF : number(answers.back());
  }

  std::uint32_t control(int controlword) { return write(0x6040, 0, 2, controlword); }
  int state() { return static_cast<int>(read(0x6041) & 0x6F); }

  void boot() { pass(0.15); }
  void start() { send(raw(0x000, {1, 5})); }
  void enable()
  {
    for (int word : {0x06, 0x07, 0x0F}) control(word);
    ASSERT_EQ(drive.power_state(), PowerState::operation_enabled);
  }

  /// Enables the drive as far as it allows it.
  void enable_if_possible()
  {
    for (int word : {0x80, 0x06, 0x07, 0x0F}) control(word);
  }

  double time() const { return static_cast<double>(ticks_) * kStep; }

  FakeDrive drive;
  AxisMotion motor;
  double motor_speed = 2e6;  ///< greatest velocity [count/s]
  bool stuck = false;
  Frames sent;

private:
  static std::uint32_t number(const can::Frame& frame)
  {
    return frame.data[4] | frame.data[5] << 8 | frame.data[6] << 16 | static_cast<std::uint32_t>(frame.data[7]) << 24;
  }

  void move()
  {
    const AxisDemand demand = drive.demand();
    double velocity = 0.0;
    if (demand.kind == AxisDemand::Kind::velocity) velocity = demand.value;
    if (demand.kind == AxisDemand::Kind::position) velocity = (demand.value - motor.position) / kStep;
    if (stuck) velocity = 0.0;
    motor.velocity = std::clamp(velocity, -motor_speed, motor_speed);
    motor.position += motor.velocity * kStep;
  }

  long ticks_ = 0;
};

/// Whether `wanted` is among them.
inline bool contains(const Frames& frames, const can::Frame& wanted)
{
  return std::find(frames.begin(), frames.end(), wanted) != frames.end();
}

/// How many of them have this id.
inline long count_of(const Frames& frames, std::uint32_t id)
{
  return std::count_if(frames.begin(), frames.end(), [id](const can::Frame& frame) { return frame.id == id; });
}

}  // namespace fourwis::drives
