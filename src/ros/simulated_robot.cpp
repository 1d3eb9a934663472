#include "simulated_robot.h"

namespace fourwis
{

SimulatedRobot::SimulatedRobot(const BaseSimulatorParameters& parameters)
  : period_(1.0 / parameters.node.publish_frequency),
    base_link_(parameters.robot),
    simulator_(parameters.robot, parameters.simulator),
    base_(parameters, simulator_),
    localization_(parameters.node, [this](const Pose& pose) { place(pose); }),
    faults_(simulator_, base_.topics(), localization_),
    fault_services_([this](const auto& fault) { faults_.inject(fault); }, [this] { faults_.clear(); }),
    clock_(
        parameters.node, [this](const ros::Time& end) { cycle(end); },
        [this](const ros::Time& now) { return base_.answered(now); })
{
  place(parameters.node.initial);
}

void SimulatedRobot::place(const Pose& pose)
{
  simulator_.place(base_link_.to_centre(pose));
}

void SimulatedRobot::cycle(const ros::Time& end)
{
  simulator_.step(period_);
  base_.publish(end);
  const Pose truth = base_link_.from_centre(simulator_.pose());
  localization_.publish(end, truth);
  localization_.correct(end, truth, base_.topics().odometry());
}

}  // namespace fourwis
