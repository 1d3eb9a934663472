#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "../support/sentences.h"
#include "fourwis_navigation/parameters/node_parameters.h"

namespace fourwis
{
namespace
{

const std::string kConfig = FOURWIS_SOURCE_DIR "/config/";

/// What the launch files put into a node's private namespace.
ParameterMap shipped(const std::string& node, const std::string& group)
{
  ParameterMap parameters = read_parameter_file(kConfig + node + ".yaml");
  for (const std::string& name : {std::string("robot"), group})
    for (const auto& [key, value] : read_parameter_file(kConfig + name + ".yaml")) parameters[name + '/' + key] = value;
  return parameters;
}

ParameterMap controller()
{
  return shipped("mpc_controller", "mpc");
}
ParameterMap simulator()
{
  return shipped("base_simulator", "simulator");
}

template <class Read>
std::string error_with(ParameterMap parameters, Read read, const std::string& key, const ParameterValue& value)
{
  parameters[key] = value;
  return error_of<ConfigError>([&] { read(parameters); });
}

template <class Read>
void expect_every_missing_key_is_told(const ParameterMap& all, Read read)
{
  for (const auto& [key, value] : all)
  {
    ParameterMap parameters = all;
    parameters.erase(key);
    std::string told;
    for (const std::string& sentence : read(parameters).defaults) told += sentence;
    EXPECT_TRUE(says(told, key.substr(key.find('/') + 1)));
  }
}

TEST(DriveParameters, the_shipped_files_are_the_defaults_of_the_controllers_node)
{
  const MpcControllerOptions options = mpc_controller_parameters_from(controller()).node, defaults;
  EXPECT_EQ(options.global_frame, defaults.global_frame);
  EXPECT_EQ(options.robot_base_frame, defaults.robot_base_frame);
  EXPECT_EQ(options.transform_tolerance, defaults.transform_tolerance);
}

TEST(DriveParameters, the_shipped_files_are_the_defaults_of_the_simulators_node)
{
  const BaseSimulatorNodeOptions options = base_simulator_parameters_from(simulator()).node, defaults;
  EXPECT_EQ(options.bus, defaults.bus);
  EXPECT_EQ(options.global_frame, defaults.global_frame);
  EXPECT_EQ(options.frames.odom_frame, defaults.frames.odom_frame);
  EXPECT_EQ(options.frames.robot_base_frame, defaults.frames.robot_base_frame);
  EXPECT_EQ(options.frames.publish_odom_tf, defaults.frames.publish_odom_tf);
  EXPECT_EQ(options.frames.wheel_radius, defaults.frames.wheel_radius);
  EXPECT_EQ(options.publish_frequency, defaults.publish_frequency);
  EXPECT_EQ(options.transform_tolerance, defaults.transform_tolerance);
  EXPECT_EQ(options.publish_clock, defaults.publish_clock);
  EXPECT_EQ(options.real_time_factor, defaults.real_time_factor);
  EXPECT_EQ(options.lockstep_period, defaults.lockstep_period);
  EXPECT_EQ(distance(options.initial, defaults.initial), 0.0);
  EXPECT_EQ(options.initial.theta, defaults.initial.theta);
}

TEST(DriveParameters, groups_reach_their_options)
{
  ParameterMap parameters = controller();
  parameters["robot/length"] = 1.25;
  parameters["mpc/controller_frequency"] = 20.0;
  EXPECT_EQ(mpc_controller_parameters_from(parameters).robot.length, 1.25);
  EXPECT_EQ(mpc_controller_parameters_from(parameters).track.controller_frequency, 20.0);
  parameters = simulator();
  parameters["simulator/seed"] = 77.0;
  EXPECT_EQ(base_simulator_parameters_from(parameters).simulator.seed, 77);
}

TEST(DriveParameters, drives_on_a_bus_are_described_and_only_they)
{
  ParameterMap parameters = simulator();
  parameters["bus"] = std::string("unix:fourwis");
  EXPECT_EQ(base_simulator_parameters_from(parameters).bridge.wheel_radius, can::BridgeOptions().wheel_radius);
  for (const auto& [key, value] : read_parameter_file(kConfig + "can_bridge.yaml"))
    parameters["can_bridge/" + key] = value;
  parameters["can_bridge/wheel_radius"] = 0.2;
  EXPECT_EQ(base_simulator_parameters_from(parameters).bridge.wheel_radius, 0.2);
  parameters["real_time_factor"] = 5.0;
  EXPECT_TRUE(says(error_of<ConfigError>([&] { base_simulator_parameters_from(parameters); }), "'real_time_factor'"));
  parameters["real_time_factor"] = 1.0;
  parameters["bus"] = std::string("direct");
  EXPECT_TRUE(says(error_of<ConfigError>([&] { base_simulator_parameters_from(parameters); }), "unknown parameter"));
}

TEST(DriveParameters, every_key_that_is_not_there_takes_its_default_and_is_told)
{
  expect_every_missing_key_is_told(controller(), mpc_controller_parameters_from);
  expect_every_missing_key_is_told(simulator(), base_simulator_parameters_from);
}

TEST(DriveParameters, what_is_unknown_or_out_of_range_is_refused_by_name)
{
  const auto of_controller = [](const std::string& key, const ParameterValue& value) {
    return error_with(controller(), mpc_controller_parameters_from, key, value);
  };
  EXPECT_TRUE(says(of_controller("speed", 1.0), "unknown parameter 'speed'"));
  EXPECT_TRUE(says(of_controller("mpc/speed", 1.0), "in 'mpc': unknown parameter 'speed'"));
  EXPECT_TRUE(says(of_controller("global_frame", std::string("/map")), "without a leading slash"));
  EXPECT_TRUE(says(of_controller("transform_tolerance", -1.0), "expected a number from 0.01 to 60 s"));

  const auto of_simulator = [](const std::string& key, const ParameterValue& value) {
    return error_with(simulator(), base_simulator_parameters_from, key, value);
  };
  EXPECT_TRUE(says(of_simulator("real_time_factor", 0.0), "expected a number from 0.01 to 1000"));
  EXPECT_TRUE(says(of_simulator("publish_clock", 1.0), "true or false"));

  ParameterMap with_another_clock = simulator();
  with_another_clock["publish_clock"] = false;
  EXPECT_EQ(base_simulator_parameters_from(with_another_clock).node.publish_clock, false);
  EXPECT_TRUE(says(error_with(with_another_clock, base_simulator_parameters_from, "real_time_factor", 5.0),
                   "'real_time_factor' is 5, expected 1 where 'publish_clock' is false"));
}

}  // namespace
}  // namespace fourwis
