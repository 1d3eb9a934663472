#include <csignal>

#include <ros/spinner.h>

#include "../can_bridge.h"
#include "../node_main.h"
#include "../parameter_server.h"

namespace
{

volatile std::sig_atomic_t asked_to_end = 0;

void ask_to_end(int)
{
  asked_to_end = 1;
}

}  // namespace

int main(int argc, char** argv)
{
  // ROS would end at once; the wheels come to rest first.
  ros::init(argc, argv, "can_bridge", ros::init_options::NoSigintHandler);
  std::signal(SIGINT, ask_to_end);
  std::signal(SIGTERM, ask_to_end);
  return fourwis::node_main([] {
    const auto parameters = fourwis::can_bridge_parameters_from(fourwis::read_parameters(ros::NodeHandle("~")));
    fourwis::warn(parameters.defaults);
    fourwis::CanBridge bridge(parameters);
    ros::AsyncSpinner spinner(2);
    spinner.start();
    while (ros::ok() && !asked_to_end) ros::WallDuration(0.02).sleep();
    bridge.end();
  });
}
