#pragma once

#include <vector>

#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis
{

struct RecordedFrame
{
  double time;  ///< when it was read [s]
  can::Frame frame;
};

/// Records all frames on a bus, at an end of its own.
class BusRecorder
{
public:
  explicit BusRecorder(can::Bus& end) : end_(end) {}

  /// Reads the frames that have come.
  void poll(double now)
  {
    for (can::Frame frame; end_.receive(frame) == can::BusStatus::ok;) frames_.push_back({now, frame});
  }

  const std::vector<RecordedFrame>& frames() const { return frames_; }
  void clear() { frames_.clear(); }

  /// The frames with this id, from a time on.
  std::vector<can::Frame> of(std::uint32_t id, double from = 0.0) const
  {
    std::vector<can::Frame> found;
    for (const RecordedFrame& recorded : frames_)
      if (recorded.frame.id == id && !recorded.frame.error && recorded.time >= from) found.push_back(recorded.frame);
    return found;
  }

private:
  can::Bus& end_;
  std::vector<RecordedFrame> frames_;
};

}  // namespace fourwis
