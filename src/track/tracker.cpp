#include "fourwis_navigation/track/tracker.h"

#include "check_trajectory.h"
#include "sequencer.h"

namespace fourwis
{

class Tracker::Implementation
{
public:
  Implementation(const Robot& its_robot, const TrackOptions& options) : robot(its_robot), sequencer(its_robot, options)
  {}

  const Robot robot;
  Sequencer sequencer;
};

Tracker::Tracker(const Robot& robot, const TrackOptions& options)
{
  check(robot, options);
  implementation_ = std::make_unique<Implementation>(robot, options);
}

Tracker::~Tracker() = default;

std::string Tracker::accept(const Trajectory& trajectory)
{
  Implementation& self = *implementation_;
  if (trajectory.empty())
  {
    stop();
    return {};
  }
  if (std::string complaint = check_trajectory(self.robot, trajectory); !complaint.empty()) return complaint;
  Mission mission = mission_of(self.robot, trajectory);
  self.sequencer.take(mission);
  return {};
}

void Tracker::stop()
{
  implementation_->sequencer.stop();
}

TrackOutput Tracker::step(const TrackInput& input)
{
  return implementation_->sequencer.step(input);
}

const std::vector<Pose>& Tracker::prediction() const
{
  return implementation_->sequencer.prediction();
}

}  // namespace fourwis
