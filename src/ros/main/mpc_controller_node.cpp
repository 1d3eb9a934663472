#include "../mpc_controller.h"
#include "../node_main.h"
#include "../parameter_server.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "mpc_controller");
  return fourwis::node_main([] {
    const auto parameters = fourwis::mpc_controller_parameters_from(fourwis::read_parameters(ros::NodeHandle("~")));
    fourwis::warn(parameters.defaults);
    const fourwis::MpcController controller(parameters);
    ros::spin();
  });
}
