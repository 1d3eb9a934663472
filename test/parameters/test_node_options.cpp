#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "fourwis_navigation/parameters/node_parameters.h"
#include "parameter_laws.h"

namespace fourwis
{

const std::string kConfig = FOURWIS_SOURCE_DIR "/config/";

/// A node's own keys and, as launch files load them, those of other files below their names.
ParameterMap with_groups(ParameterMap parameters, std::initializer_list<const char*> groups)
{
  for (const std::string group : groups)
    for (const auto& [key, value] : read_parameter_file(kConfig + group + ".yaml"))
      parameters[group + '/' + key] = value;
  return parameters;
}

template <>
Subject<GlobalPlannerOptions> subject_of()
{
  using O = GlobalPlannerOptions;
  return {kConfig + "global_planner.yaml",
          [](const ParameterMap& own) {
            return global_planner_parameters_from(with_groups(own, {"robot", "planner"})).node;
          },
          {{"global_frame", [](const O& o) { return double(o.global_frame == "map"); }},
           {"robot_base_frame", [](const O& o) { return double(o.robot_base_frame == "base_link"); }},
           {"transform_tolerance", [](const O& o) { return o.transform_tolerance; }, {0.01, 60.0}},
           {"start_from", [](const O& o) { return double(o.start_from); }},
           {"modes", [](const O& o) { return double(o.modes.contains(Mode::ackermann)); }},
           {"wait_for_controller", [](const O& o) { return double(o.wait_for_controller); }},
           {"controller_patience", [](const O& o) { return o.controller_patience; }, {0.1, 60.0}},
           {"replan_attempts", [](const O& o) { return double(o.replan_attempts); }, {0, 100, kWhole}},
           {"start_delay", [](const O& o) { return o.start_delay; }, {0.0, 10.0}},
           {"stop_delay", [](const O& o) { return o.stop_delay; }, {0.0, 0.5}},
           {"show_expansions", [](const O& o) { return double(o.show_expansions); }},
           {"show_corridors", [](const O& o) { return double(o.show_corridors); }},
           {"show_iterations", [](const O& o) { return double(o.show_iterations); }}}};
}

template <>
Subject<MpcControllerOptions> subject_of()
{
  using O = MpcControllerOptions;
  return {kConfig + "mpc_controller.yaml",
          [](const ParameterMap& own) {
            return mpc_controller_parameters_from(with_groups(own, {"robot", "mpc"})).node;
          },
          {{"global_frame", [](const O& o) { return double(o.global_frame == "map"); }},
           {"robot_base_frame", [](const O& o) { return double(o.robot_base_frame == "base_link"); }},
           {"transform_tolerance", [](const O& o) { return o.transform_tolerance; }, {0.01, 60.0}},
           {"require_permit", [](const O& o) { return double(o.require_permit); }}}};
}

template <>
Subject<CanBridgeNodeOptions> subject_of()
{
  using O = CanBridgeNodeOptions;
  return {kConfig + "can_bridge_node.yaml",
          [](const ParameterMap& own) {
            return can_bridge_parameters_from(with_groups(own, {"robot", "can_bridge"})).node;
          },
          {{"odom_frame", [](const O& o) { return double(o.frames.odom_frame == "odom"); }},
           {"robot_base_frame", [](const O& o) { return double(o.frames.robot_base_frame == "base_link"); }},
           {"publish_odom_tf", [](const O& o) { return double(o.frames.publish_odom_tf); }},
           {"real_time_priority", [](const O& o) { return double(o.real_time_priority); }, {0, 99, kWhole}}}};
}

BaseSimulatorNodeOptions read_simulator_node(const ParameterMap& own)
{
  ParameterMap all = with_groups(own, {"robot", "simulator"});
  if (own.count("bus") > 0 && own.at("bus") != ParameterValue(kDirect)) all = with_groups(all, {"can_bridge"});
  return base_simulator_parameters_from(all).node;
}

template <>
Subject<BaseSimulatorNodeOptions> subject_of()
{
  using O = BaseSimulatorNodeOptions;
  return {kConfig + "base_simulator.yaml",
          read_simulator_node,
          {{"bus", [](const O& o) { return double(o.bus == kDirect); }},
           {"global_frame", [](const O& o) { return double(o.global_frame == "map"); }},
           {"odom_frame", [](const O& o) { return double(o.frames.odom_frame == "odom"); }},
           {"robot_base_frame", [](const O& o) { return double(o.frames.robot_base_frame == "base_link"); }},
           {"publish_odom_tf", [](const O& o) { return double(o.frames.publish_odom_tf); }},
           {"wheel_radius", [](const O& o) { return o.frames.wheel_radius; }, {0.01, 2.0}},
           {"publish_frequency", [](const O& o) { return o.publish_frequency; }, {1.0, 1000.0}},
           {"transform_tolerance", [](const O& o) { return o.transform_tolerance; }, {0.0, 10.0}},
           {"publish_clock", [](const O& o) { return double(o.publish_clock); }},
           {"real_time_factor", [](const O& o) { return o.real_time_factor; }, {0.01, 1000.0}},
           {"lockstep_period", [](const O& o) { return o.lockstep_period; }, {0.0, 1.0}},
           {"initial_x", [](const O& o) { return o.initial.x; }, {-1e6, 1e6}},
           {"initial_y", [](const O& o) { return o.initial.y; }, {-1e6, 1e6}},
           {"initial_yaw", [](const O& o) { return o.initial.theta; }, {-2.0 * M_PI, 2.0 * M_PI}}}};
}

using NodeOptions =
    testing::Types<GlobalPlannerOptions, MpcControllerOptions, CanBridgeNodeOptions, BaseSimulatorNodeOptions>;
INSTANTIATE_TYPED_TEST_SUITE_P(NodeFiles, ParameterLaws, NodeOptions);

}  // namespace fourwis
