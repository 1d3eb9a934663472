#include <initializer_list>
#include <string>

#include <gtest/gtest.h>

#include "../support/sentences.h"
#include "fourwis_navigation/parameters/node_parameters.h"

namespace fourwis
{
namespace
{

// What one file says and another one contradicts, node by node.

const std::string kConfig = FOURWIS_SOURCE_DIR "/config/";

/// What roslaunch puts into a node's private namespace.
ParameterMap loaded(const std::string& node, std::initializer_list<std::string> groups)
{
  ParameterMap parameters = read_parameter_file(kConfig + node + ".yaml");
  for (const std::string& group : groups)
    for (const auto& [key, value] : read_parameter_file(kConfig + group + ".yaml"))
      parameters[group + '/' + key] = value;
  return parameters;
}

ParameterMap planner()
{
  ParameterMap parameters = loaded("global_planner", {"robot", "planner"});
  parameters["wait_for_controller"] = true;
  return parameters;
}

ParameterMap controller()
{
  return loaded("mpc_controller", {"robot", "mpc"});
}

ParameterMap bridge()
{
  return loaded("can_bridge_node", {"robot", "can_bridge"});
}

ParameterMap simulator()
{
  return loaded("base_simulator", {"robot", "simulator"});
}

ParameterMap simulated_drives()
{
  ParameterMap parameters = loaded("base_simulator", {"robot", "simulator", "can_bridge"});
  parameters["bus"] = std::string("unix:test");
  return parameters;
}

using Changes = std::initializer_list<ParameterMap::value_type>;

template <class Read>
std::string rejection(Read read, ParameterMap parameters, Changes changes)
{
  for (const auto& [key, value] : changes) parameters[key] = value;
  return error_of<ConfigError>([&] { read(parameters); });
}

TEST(AcrossFiles, the_shipped_files_agree)
{
  EXPECT_EQ(rejection(global_planner_parameters_from, planner(), {}), "");
  EXPECT_EQ(rejection(mpc_controller_parameters_from, controller(), {}), "");
  EXPECT_EQ(rejection(can_bridge_parameters_from, bridge(), {}), "");
  EXPECT_EQ(rejection(base_simulator_parameters_from, simulator(), {}), "");
  EXPECT_EQ(rejection(base_simulator_parameters_from, simulated_drives(), {}), "");
}

/// Each mode of wheels that turn at 0.4 rad/s could be 9 s away.
TEST(AcrossFiles, wheels_that_turn_too_slowly_for_an_alignment_timeout_are_rejected)
{
  const Changes slow = {{"robot/wheel_max_rate", 0.4}};
  const std::string rate = "'wheel_max_rate' is 0.4 rad/s";
  const std::string of_bridge = rejection(can_bridge_parameters_from, bridge(), slow);
  EXPECT_TRUE(says(of_bridge, "in 'robot' and 'can_bridge': parameter 'alignment_timeout' is 3, expected at least"));
  EXPECT_TRUE(says(of_bridge, rate));
  EXPECT_EQ(rejection(base_simulator_parameters_from, simulated_drives(), slow), of_bridge);

  const std::string of_simulator = rejection(base_simulator_parameters_from, simulator(), slow);
  EXPECT_TRUE(says(of_simulator, "in 'robot' and 'simulator': parameter 'alignment_timeout' is 3, expected at least"));
  EXPECT_TRUE(says(of_simulator, rate));

  const std::string of_controller = rejection(mpc_controller_parameters_from, controller(), slow);
  EXPECT_TRUE(says(of_controller, "in 'robot' and 'mpc': parameter 'alignment_timeout' is 5, expected at least"));
  EXPECT_TRUE(says(of_controller, rate));
}

TEST(AcrossFiles, they_are_accepted_with_timeouts_that_are_long_enough)
{
  EXPECT_EQ(rejection(can_bridge_parameters_from, bridge(),
                      {{"robot/wheel_max_rate", 0.4}, {"can_bridge/alignment_timeout", 10.0}}),
            "");
  EXPECT_EQ(rejection(base_simulator_parameters_from, simulator(),
                      {{"robot/wheel_max_rate", 0.4}, {"simulator/alignment_timeout", 10.0}}),
            "");
  EXPECT_EQ(rejection(mpc_controller_parameters_from, controller(),
                      {{"robot/wheel_max_rate", 0.4}, {"mpc/alignment_timeout", 10.0}}),
            "");
}

TEST(AcrossFiles, wheels_that_turn_farther_than_a_rangers_are_rejected)
{
  const std::string text =
      rejection(can_bridge_parameters_from, bridge(), {{"can_bridge/protocol", std::string("ranger")}});
  EXPECT_TRUE(says(text, "in 'robot' and 'can_bridge': parameter 'wheel_max_angle' is 2.79"));
  EXPECT_TRUE(says(text, "where 'protocol' is 'ranger'"));
}

TEST(AcrossFiles, corrections_faster_than_the_robot_are_rejected)
{
  EXPECT_TRUE(says(rejection(mpc_controller_parameters_from, controller(), {{"robot/max_speed", 0.05}}),
                   "in 'robot' and 'mpc': parameter 'correction_speed' is 0.1, expected at most 'max_speed'"));
}

/// 1 m/s takes 5 s to brake at 0.2 m/s^2.
TEST(AcrossFiles, a_planner_that_does_not_wait_for_the_robot_to_brake_is_rejected)
{
  const Changes gentle = {{"robot/max_acceleration", 0.2}};
  const std::string text = rejection(global_planner_parameters_from, planner(), gentle);
  EXPECT_TRUE(says(text, "'controller_patience' is 5, expected at least 6 s"));
  EXPECT_TRUE(says(text, "'max_speed' is 1 m/s and 'max_acceleration' 0.2 m/s^2"));
  EXPECT_EQ(rejection(global_planner_parameters_from, planner(),
                      {{"robot/max_acceleration", 0.2}, {"controller_patience", 6.0}}),
            "");
  EXPECT_EQ(rejection(global_planner_parameters_from, planner(),
                      {{"robot/max_acceleration", 0.2}, {"wait_for_controller", false}}),
            "")
      << "there is no controller to wait for";
}

}  // namespace
}  // namespace fourwis
