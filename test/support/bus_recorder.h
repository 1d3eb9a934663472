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

/// Listens at an end of its own to all that is said on a bus.
class BusRecorder
{
public:
  explicit BusRecorder(can::Bus& end) : end_(end) {}

  /// Reads what has come by now.
  void poll(double now)
  {
    for (can::Frame frame; end_.receive(frame) == can::BusStatus::ok;) frames_.push_back({now, frame});
  }

  const std::vector<RecordedFrame>& frames() const { return frames_; }
  void clear() { frames_.clear(); }

  /// Those of this id, from a time on.
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
