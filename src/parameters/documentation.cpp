#include "fourwis_navigation/parameters/documentation.h"

#include "fourwis_navigation/parameters/node_options.h"
#include "parameter_list.h"

namespace fourwis
{
namespace
{

constexpr const char* kPreface =
    "# Parameters\n"
    "\n"
    "Every key with its default and what it may be, as `plan --list-parameters` prints it: the program reads the "
    "tables beside\n"
    "the structs of options, and so do the checks. What a key means is told in its file, and beside its member. "
    "Values\n"
    "that contradict each other are rejected as well. A missing key takes its default, which is told once at start; "
    "an\n"
    "unknown one is rejected.\n"
    "\n"
    "A file means the same to `plan`, to the nodes (roslaunch and rosparam put it on the parameter server) and to\n"
    "`urdf/fit_to_robot.py`. It is YAML 1.1, as PyYAML reads it, with two additions: a text that is a decimal number,\n"
    "like `2e-2` to PyYAML or `'0.02'`, is that number; angles may be written `deg(30)` or `rad(pi/6)`, with numbers, "
    "pi,\n"
    "`+ - * /`. So `010` is 8 (octal), `1_000` is 1000, `yes` and `off` are true and false; `08`, `inf` and `nan` are "
    "no\n"
    "numbers. A whole number beyond 31 bits is rejected, because the parameter server has none: write `3e9`.\n";

template <class Options>
std::string table_of(const std::string& title, const std::string& reader)
{
  std::string text = "\n## " + title + "\n" + reader + "\n\n| key | default | range | unit |\n|---|---|---|---|\n";
  Options options;
  for (const Parameter& parameter : ParameterList::of(options))
    text +=
        "| `" + parameter.key + "` | " + parameter.value + " | " + parameter.range + " | " + parameter.unit + " |\n";
  return text;
}

}  // namespace

std::string parameter_documentation()
{
  return kPreface + table_of<Robot>("config/robot.yaml", "All nodes, and `plan --robot`.") +
         table_of<PlannerOptions>("config/planner.yaml",
                                  "`global_planner_node` below `planner/`, and `plan --planner`.") +
         table_of<TrackOptions>("config/mpc.yaml", "`mpc_controller_node` below `mpc/`.") +
         table_of<can::BridgeOptions>("config/can_bridge.yaml",
                                      "`can_bridge_node`, and `base_simulator_node` with a bus, below `can_bridge/`.") +
         table_of<SimulatorOptions>("config/simulator.yaml", "`base_simulator_node` below `simulator/`.") +
         table_of<GlobalPlannerOptions>("config/global_planner.yaml", "`global_planner_node` itself.") +
         table_of<MpcControllerOptions>("config/mpc_controller.yaml", "`mpc_controller_node` itself.") +
         table_of<CanBridgeNodeOptions>("config/can_bridge_node.yaml", "`can_bridge_node` itself.") +
         table_of<BaseSimulatorNodeOptions>("config/base_simulator.yaml", "`base_simulator_node` itself.") +
         table_of<MapPublisherOptions>("map_publisher_node", "Without a file; missing keys take their defaults.") +
         table_of<OctomapProjectorOptions>("octomap_projector_node",
                                           "Without a file; missing keys take their defaults.");
}

}  // namespace fourwis
