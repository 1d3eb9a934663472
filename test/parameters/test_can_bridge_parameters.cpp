#include <string>

#include <gtest/gtest.h>

#include "../support/sentences.h"
#include "fourwis_navigation/parameters/node_parameters.h"

namespace fourwis
{
namespace
{

const std::string kConfig = FOURWIS_SOURCE_DIR "/config/";

/// The parameters as robot.launch loads them.
ParameterMap shipped()
{
  ParameterMap parameters = read_parameter_file(kConfig + "can_bridge_node.yaml");
  for (const std::string group : {"robot", "can_bridge"})
    for (const auto& [key, value] : read_parameter_file(kConfig + group + ".yaml"))
      parameters[group + '/' + key] = value;
  return parameters;
}

std::string rejection(const std::string& key, const ParameterValue& value)
{
  ParameterMap parameters = shipped();
  parameters[key] = value;
  return error_of<ConfigError>([&] { can_bridge_parameters_from(parameters); });
}

TEST(CanBridgeParameters, ShippedFilesAreTheDefaults)
{
  const CanBridgeParameters parameters = can_bridge_parameters_from(shipped()), defaults;
  EXPECT_EQ(parameters.node.frames.odom_frame, defaults.node.frames.odom_frame);
  EXPECT_EQ(parameters.node.frames.robot_base_frame, defaults.node.frames.robot_base_frame);
  EXPECT_EQ(parameters.node.frames.publish_odom_tf, defaults.node.frames.publish_odom_tf);
  EXPECT_EQ(parameters.node.real_time_priority, defaults.node.real_time_priority);
  EXPECT_EQ(parameters.bridge.interface, defaults.bridge.interface);
}

TEST(CanBridgeParameters, TheWheelsOfThePictureAreThoseOfTheDrives)
{
  ParameterMap parameters = shipped();
  parameters["can_bridge/wheel_radius"] = 0.2;
  EXPECT_EQ(can_bridge_parameters_from(parameters).node.frames.wheel_radius, 0.2);
}

TEST(CanBridgeParameters, WhatIsWrongIsNamed)
{
  EXPECT_TRUE(says(rejection("real_time_priority", 100.0), "'real_time_priority' is 100, expected"));
  EXPECT_TRUE(says(rejection("odom_frame", std::string("/odom")), "'odom_frame' is '/odom', expected"));
  EXPECT_TRUE(says(rejection("can_bridge/bit_rate", 1.0), "in 'can_bridge': parameter 'bit_rate' is 1, expected"));
  EXPECT_TRUE(says(rejection("speed", 1.0), "unknown parameter 'speed'"));
}

}  // namespace
}  // namespace fourwis
