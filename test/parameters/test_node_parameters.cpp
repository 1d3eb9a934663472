#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "../support/sentences.h"
#include "fourwis_navigation/parameters/node_parameters.h"

namespace fourwis
{
namespace
{

const std::string kConfig = FOURWIS_SOURCE_DIR "/config/";

/// What roslaunch puts into the planner's private namespace.
ParameterMap shipped()
{
  ParameterMap parameters = read_parameter_file(kConfig + "global_planner.yaml");
  for (const std::string group : {"robot", "planner"})
    for (const auto& [key, value] : read_parameter_file(kConfig + group + ".yaml"))
      parameters[group + '/' + key] = value;
  return parameters;
}

std::string error_with(const std::string& key, const ParameterValue& value)
{
  ParameterMap parameters = shipped();
  parameters[key] = value;
  return error_of<ConfigError>([&] { global_planner_parameters_from(parameters); });
}

TEST(NodeParameters, the_shipped_files_are_the_defaults_of_the_node)
{
  const GlobalPlannerOptions options = global_planner_parameters_from(shipped()).node;
  const GlobalPlannerOptions defaults;
  EXPECT_EQ(options.global_frame, defaults.global_frame);
  EXPECT_EQ(options.robot_base_frame, defaults.robot_base_frame);
  EXPECT_EQ(options.transform_tolerance, defaults.transform_tolerance);
  EXPECT_EQ(options.start_from, defaults.start_from);
  EXPECT_TRUE(options.modes == (ModeSet{Mode::ackermann, Mode::lateral, Mode::parallel}));
  EXPECT_EQ(options.wait_for_controller, defaults.wait_for_controller);
  EXPECT_EQ(options.controller_patience, defaults.controller_patience);
  EXPECT_EQ(options.replan_attempts, defaults.replan_attempts);
  EXPECT_EQ(options.start_delay, defaults.start_delay);
  EXPECT_EQ(options.stop_delay, defaults.stop_delay);
  EXPECT_EQ(options.show_expansions, defaults.show_expansions);
  EXPECT_EQ(options.show_corridors, defaults.show_corridors);
  EXPECT_EQ(options.show_iterations, defaults.show_iterations);
}

TEST(NodeParameters, each_key_sets_what_it_names)
{
  ParameterMap parameters = shipped();
  parameters["global_frame"] = std::string("world");
  parameters["robot_base_frame"] = std::string("base_footprint");
  parameters["transform_tolerance"] = 1.5;
  parameters["start_from"] = std::string("initialpose");
  parameters["modes"] = std::string("parallel,ackermann");
  parameters["wait_for_controller"] = true;
  parameters["controller_patience"] = 3.0;
  parameters["replan_attempts"] = 5.0;
  parameters["start_delay"] = 0.5;
  parameters["stop_delay"] = 0.1;
  parameters["show_expansions"] = true;
  parameters["show_corridors"] = true;
  parameters["show_iterations"] = true;
  parameters["robot/length"] = 1.25;
  parameters["planner/planner_patience"] = 7.0;
  const GlobalPlannerParameters read = global_planner_parameters_from(parameters);
  EXPECT_EQ(read.node.global_frame, "world");
  EXPECT_EQ(read.node.robot_base_frame, "base_footprint");
  EXPECT_EQ(read.node.transform_tolerance, 1.5);
  EXPECT_EQ(read.node.start_from, StartFrom::initial_pose);
  EXPECT_TRUE(read.node.modes == (ModeSet{Mode::ackermann, Mode::parallel}));
  EXPECT_TRUE(read.node.wait_for_controller);
  EXPECT_EQ(read.node.controller_patience, 3.0);
  EXPECT_EQ(read.node.replan_attempts, 5);
  EXPECT_EQ(read.node.start_delay, 0.5);
  EXPECT_EQ(read.node.stop_delay, 0.1);
  EXPECT_TRUE(read.node.show_expansions);
  EXPECT_TRUE(read.node.show_corridors);
  EXPECT_TRUE(read.node.show_iterations);
  EXPECT_EQ(read.robot.length, 1.25);
  EXPECT_EQ(read.planner.planner_patience, 7.0);
}

TEST(NodeParameters, a_missing_key_takes_its_default_and_is_told_with_it)
{
  EXPECT_TRUE(global_planner_parameters_from(shipped()).defaults.empty());
  for (const auto& [key, value] : shipped())
  {
    ParameterMap parameters = shipped();
    parameters.erase(key);
    const GlobalPlannerParameters read = global_planner_parameters_from(parameters);
    ASSERT_EQ(read.defaults.size(), 1u) << key;
    const std::size_t slash = key.find('/');
    const std::string group = slash == std::string::npos ? "" : "in '" + key.substr(0, slash) + "': ";
    EXPECT_EQ(
        read.defaults[0].rfind(group + "missing parameters take their defaults: " + key.substr(slash + 1) + " = ", 0),
        0u)
        << read.defaults[0];
  }
}

TEST(NodeParameters, nothing_given_is_all_defaults_told_group_by_group)
{
  const GlobalPlannerParameters read = global_planner_parameters_from({});
  EXPECT_EQ(read.robot.length, Robot().length);
  EXPECT_EQ(read.planner.planner_patience, PlannerOptions().planner_patience);
  ASSERT_EQ(read.defaults.size(), 3u);
  EXPECT_TRUE(says(read.defaults[0], "in 'robot': missing parameters take their defaults: length = 1, width = 0.62, "));
  EXPECT_TRUE(says(read.defaults[1], "in 'planner': missing"));
  EXPECT_TRUE(says(read.defaults[2], "modes = ackermann,lateral,parallel"));
}

TEST(NodeParameters, an_unknown_key_is_refused_by_name_wherever_it_is)
{
  EXPECT_TRUE(says(error_with("speed", 1.0), "'speed'"));
  EXPECT_TRUE(says(error_with("robot/colour", std::string("red")), "'colour'"));
  EXPECT_TRUE(says(error_with("robot/colour", std::string("red")), "in 'robot'"));
  EXPECT_TRUE(says(error_with("planner/horizon", 1.0), "'horizon'"));
  EXPECT_TRUE(says(error_with("controller/rate", 1.0), "'controller/rate'"));
}

TEST(NodeParameters, a_value_out_of_range_or_of_another_type_is_refused_with_what_is_allowed)
{
  EXPECT_TRUE(
      says(error_with("transform_tolerance", 0.0), "'transform_tolerance' is 0, expected a number from 0.01 to 60 s"));
  EXPECT_TRUE(says(error_with("transform_tolerance", std::string("soon")), "'soon'"));
  EXPECT_TRUE(says(error_with("start_from", std::string("nowhere")), "'nowhere', expected one of tf, initialpose"));
  EXPECT_TRUE(says(error_with("modes", std::string("ackermann,sideways")), "ackermann, lateral and parallel"));
  EXPECT_TRUE(says(error_with("modes", std::string("")), "ackermann, lateral and parallel"));
  EXPECT_TRUE(says(error_with("wait_for_controller", std::string("mpc")), "true or false"));
  EXPECT_TRUE(says(error_with("replan_attempts", 1.5),
                   "'replan_attempts' is 1.5, expected a whole number from 0 to 100 attempts"));
  EXPECT_TRUE(says(error_with("replan_attempts", -1.0), "a whole number from 0 to 100 attempts"));
  EXPECT_TRUE(says(error_with("show_expansions", 1.0), "true or false"));
  EXPECT_TRUE(says(error_with("show_corridors", std::string("yes")), "true or false"));
  EXPECT_TRUE(says(error_with("global_frame", std::string("")), "name of a tf frame"));
  EXPECT_TRUE(says(error_with("robot_base_frame", std::string("/base_link")), "without a leading slash"));
  EXPECT_TRUE(says(error_with("robot/length", -1.0), "'length' is -1"));
}

TEST(NodeParameters, keys_of_the_libraries_in_the_same_namespace_are_left_to_them)
{
  EXPECT_EQ(error_with("diagnostic_period", 2.0), "");
  EXPECT_EQ(error_with("actionlib_status_frequency", 10.0), "");
}

TEST(NodeParameters, the_map_publisher_takes_its_file_from_the_parameter_or_the_command_line)
{
  EXPECT_EQ(map_publisher_options_from({}, "a.yaml").map_file, "a.yaml");
  EXPECT_EQ(map_publisher_options_from({{"map_file", std::string("b.yaml")}}, "a.yaml").map_file, "b.yaml");
  EXPECT_EQ(map_publisher_options_from({}, "a.yaml").frame_id, "map");
  EXPECT_EQ(map_publisher_options_from({{"frame_id", std::string("world")}}, "a.yaml").frame_id, "world");
  EXPECT_TRUE(says(error_of<ConfigError>([] { map_publisher_options_from({}, ""); }), "'map_file'"));
  const ParameterMap unknown = {{"frame", std::string("x")}}, empty = {{"frame_id", std::string()}};
  EXPECT_TRUE(says(error_of<ConfigError>([&] { map_publisher_options_from(unknown, "a.yaml"); }), "'frame'"));
  EXPECT_TRUE(says(error_of<ConfigError>([&] { map_publisher_options_from(empty, "a.yaml"); }), "'frame_id'"));
}

TEST(NodeParameters, the_projectors_height_band_must_not_be_upside_down)
{
  const ParameterMap file = {{"octomap_file", std::string("a.bt")}};
  EXPECT_EQ(octomap_projector_options_from(file).band.max, HeightBand().max);
  ParameterMap band = file;
  band["min_height"] = 0.5;
  band["max_height"] = 0.4;
  EXPECT_TRUE(says(error_of<ConfigError>([&] { octomap_projector_options_from(band); }),
                   "'max_height' is 0.4, expected more than min_height, 0.5 m"));
  EXPECT_TRUE(says(error_of<ConfigError>([] { octomap_projector_options_from({}); }), "'octomap_file'"));
}

}  // namespace
}  // namespace fourwis
