#include "../node_main.h"
#include "../parameter_server.h"
#include "../simulated_drives.h"
#include "../simulated_robot.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "base_simulator");
  return fourwis::node_main([] {
    const auto parameters = fourwis::base_simulator_parameters_from(fourwis::read_parameters(ros::NodeHandle("~")));
    fourwis::warn(parameters.defaults);
    if (parameters.node.bus == fourwis::kDirect)
    {
      const fourwis::SimulatedRobot robot(parameters);
      ros::spin();
    }
    else
    {
      const fourwis::SimulatedDrives drives(parameters);
      ros::spin();
    }
  });
}
