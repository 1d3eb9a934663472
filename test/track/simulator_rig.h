#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "fourwis_navigation/sim/base_simulator.h"
#include "fourwis_navigation/track/tracker.h"

namespace fourwis
{

/// A tracker on the simulated base with its usual lags and latency, localised exactly.
class SimulatorRig
{
public:
  explicit SimulatorRig(const Pose& start, const SimulatorOptions& options = {})
    : base(robot, options),
      tracker(robot, {})
  {
    base.place(start);
  }

  /// Steps until the tracker has driven and rests again, or for `patience` [s].
  void run(double patience, const std::function<void()>& each_step = {})
  {
    for (bool busy = false; base.time() < patience;)
    {
      output = tracker.step({base.time(), base.time(), base.pose(), base.wheels()});
      message = std::string(output.message);
      const bool resting =
          output.state == TrackState::idle || output.state == TrackState::arrived || output.state == TrackState::failed;
      if (busy && resting) return;
      busy |= !resting;
      if (each_step) each_step();
      base.command(output.command);
      base.step(0.02);
    }
  }

  const Robot robot;
  BaseSimulator base;
  Tracker tracker;
  TrackOutput output;
  std::string message;  ///< of the last step
};

}  // namespace fourwis
