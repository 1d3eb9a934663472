#include "fourwis_navigation/parameters/node_parameters.h"

#include <utility>
#include <vector>

#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/model/sentence.h"
#include "parameter_list.h"

namespace fourwis
{
namespace
{

/// A node's private namespace: groups of keys, each of a configuration of its own, and the node's own keys.
class NodeNamespace
{
public:
  /// `foreign` keys may be there and are read by libraries that share the namespace.
  NodeNamespace(ParameterMap given, const std::vector<std::string>& foreign) : given_(std::move(given))
  {
    for (const std::string& key : foreign) given_.erase(key);
  }

  /// Whether the key is there, with another value.
  bool differs(const std::string& key, const ParameterValue& value) const
  {
    const auto found = given_.find(key);
    return found != given_.end() && found->second != value;
  }

  /// What `read` makes of all keys below `name/`, without that prefix.
  template <class Options>
  Options group(const std::string& name, Options (*read)(const ParameterMap&))
  {
    const ParameterMap members = take(name + '/');
    const std::string taken = defaults_taken<Options>(members);
    if (!taken.empty()) defaults_.push_back("in '" + name + "': " + taken);
    try
    {
      return read(members);
    }
    catch (const ConfigError& error)
    {
      reject<ConfigError>("in '", name, "': ", error.what());
    }
  }

  /// What is left are the node's own keys.
  template <class Options>
  Options own()
  {
    Options options;
    const std::vector<Parameter> parameters = ParameterList::of(options);
    const std::string taken = defaults_taken(given_, parameters);
    if (!taken.empty()) defaults_.push_back(taken);
    set_from(given_, parameters, groups_);
    return options;
  }

  /// A sentence for each group with missing keys.
  const std::vector<std::string>& defaults() const { return defaults_; }

private:
  ParameterMap take(const std::string& prefix)
  {
    groups_.push_back(prefix + "...");
    ParameterMap members;
    for (auto it = given_.lower_bound(prefix); it != given_.end() && it->first.rfind(prefix, 0) == 0;)
    {
      members[it->first.substr(prefix.size())] = it->second;
      it = given_.erase(it);
    }
    return members;
  }

  ParameterMap given_;
  std::vector<std::string> groups_, defaults_;
};

/// Read by diagnostic_updater.
const std::vector<std::string> kOfDiagnostics = {"diagnostic_period"};
/// Read by diagnostic_updater and actionlib, which share the namespace of a node that is named after its action.
const std::vector<std::string> kOfDiagnosticsAndAction = {"diagnostic_period",
                                                          "status_frequency",
                                                          "status_list_timeout",
                                                          "actionlib_status_frequency",
                                                          "actionlib_server_pub_queue_size",
                                                          "actionlib_server_sub_queue_size"};

/// What these options and the robot say of each other, which two files hold.
template <class Options>
void check_with_robot(const Robot& robot, const std::string& group, const Options& options)
{
  try
  {
    check(robot, options);
  }
  catch (const std::invalid_argument& error)
  {
    reject<ConfigError>("in 'robot' and '", group, "': ", error.what());
  }
}

/// A robot that brakes from its greatest speed must not be taken for one that does not stop.
void check_patience(const Robot& robot, const GlobalPlannerOptions& options)
{
  constexpr double kSeenLate = 1.0;  // the controller counts a robot as at rest this long after it should be [s]
  const double needed = robot.max_speed / robot.max_acceleration + kSeenLate;
  if (!options.wait_for_controller || options.controller_patience >= needed) return;
  reject<ConfigError>("parameter 'controller_patience' is ", to_text(options.controller_patience),
                      ", expected at least ", to_text(needed), " s: in 'robot', 'max_speed' is ",
                      to_text(robot.max_speed), " m/s and 'max_acceleration' ", to_text(robot.max_acceleration),
                      " m/s^2");
}

/// Defaults for what is missing but one key, which must be there and not empty.
template <class Options>
void set_with_defaults(const ParameterMap& given, Options& options, std::string Options::*needed,
                       const std::string& key)
{
  set_from(given, ParameterList::of(options));
  if ((options.*needed).empty()) reject<ConfigError>("missing parameter '", key, "'");
}

}  // namespace

void check(const BaseSimulatorNodeOptions& options)
{
  check_ranges(options);
  const bool has_bus = options.bus != kDirect;
  if (options.real_time_factor == 1.0 || (!has_bus && options.publish_clock)) return;
  reject_option("real_time_factor", to_text(options.real_time_factor),
                has_bus ? "1 where 'bus' is '" + options.bus + "': its drives run in real time"
                        : "1 where 'publish_clock' is false: time is not the simulator's");
}

GlobalPlannerParameters global_planner_parameters_from(const ParameterMap& parameters)
{
  NodeNamespace given(parameters, kOfDiagnosticsAndAction);
  GlobalPlannerParameters result;
  result.robot = given.group("robot", robot_from);
  result.planner = given.group("planner", planner_options_from);
  result.node = given.own<GlobalPlannerOptions>();
  result.defaults = given.defaults();
  check_patience(result.robot, result.node);
  return result;
}

MpcControllerParameters mpc_controller_parameters_from(const ParameterMap& parameters)
{
  NodeNamespace given(parameters, kOfDiagnostics);
  MpcControllerParameters result;
  result.robot = given.group("robot", robot_from);
  result.track = given.group("mpc", track_options_from);
  result.node = given.own<MpcControllerOptions>();
  result.defaults = given.defaults();
  check_with_robot(result.robot, "mpc", result.track);
  return result;
}

CanBridgeParameters can_bridge_parameters_from(const ParameterMap& parameters)
{
  NodeNamespace given(parameters, kOfDiagnostics);
  CanBridgeParameters result;
  result.robot = given.group("robot", robot_from);
  result.bridge = given.group("can_bridge", bridge_options_from);
  result.node = given.own<CanBridgeNodeOptions>();
  result.defaults = given.defaults();
  check_with_robot(result.robot, "can_bridge", result.bridge);
  result.node.frames.wheel_radius = result.bridge.wheel_radius;
  return result;
}

BaseSimulatorParameters base_simulator_parameters_from(const ParameterMap& parameters)
{
  NodeNamespace given(parameters, {});
  BaseSimulatorParameters result;
  result.robot = given.group("robot", robot_from);
  result.simulator = given.group("simulator", simulator_options_from);
  const bool has_bus = given.differs("bus", kDirect);
  if (has_bus) result.bridge = given.group("can_bridge", bridge_options_from);
  result.node = given.own<BaseSimulatorNodeOptions>();
  result.defaults = given.defaults();
  check_configuration(result.node);
  if (has_bus)
    check_with_robot(result.robot, "can_bridge", result.bridge);
  else
    check_with_robot(result.robot, "simulator", result.simulator);
  return result;
}

MapPublisherOptions map_publisher_options_from(const ParameterMap& parameters, const std::string& argument)
{
  MapPublisherOptions options;
  options.map_file = argument;
  set_with_defaults(parameters, options, &MapPublisherOptions::map_file, "map_file");
  return options;
}

OctomapProjectorOptions octomap_projector_options_from(const ParameterMap& parameters)
{
  OctomapProjectorOptions options;
  set_with_defaults(parameters, options, &OctomapProjectorOptions::octomap_file, "octomap_file");
  check_configuration(options.band);
  return options;
}

}  // namespace fourwis
