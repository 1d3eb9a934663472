#pragma once

#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{

/// Where the start pose of a plan comes from.
enum class StartFrom
{
  tf,           ///< where tf has robot_base_frame in global_frame
  initial_pose  ///< the last message on `initialpose`
};

/// The keys of `config/global_planner.yaml`, in the private namespace of global_planner_node.
struct GlobalPlannerOptions
{
  std::string global_frame = "map";            ///< frame of the map and of everything published
  std::string robot_base_frame = "base_link";  ///< the robot's centre
  double transform_tolerance = 0.5;            ///< greatest age of the robot's transform [s]
  StartFrom start_from = StartFrom::tf;
  ModeSet modes;                     ///< what goals are planned with
  bool wait_for_controller = false;  ///< whether there is a controller, whose reports say how goals end
  double controller_patience = 5.0;  ///< how long it may say nothing, begin late, or take to stop [s]
  int replan_attempts = 2;           ///< new plans for a goal after the controller has given one up
  double start_delay = 0.2;          ///< from the time a plan starts from to the time it begins [s]
  double stop_delay = 0.05;          ///< from the reason to stop to the time at which it begins [s]
  bool show_expansions = false;      ///< draw the nodes that the search expanded
  bool show_corridors = false;       ///< draw the regions that the optimisation kept the disc centres in
  bool show_iterations = false;      ///< draw what each round of the optimisation made of the path
};

/// Everything that global_planner_node is configured with.
struct GlobalPlannerParameters
{
  Robot robot;
  PlannerOptions planner;
  GlobalPlannerOptions node;
};

/// Flattens a struct of the parameter server; numbers become double. Throws ConfigError, naming the key, for what has
/// no place in a ParameterMap: lists, dates, binary data.
ParameterMap to_parameters(const XmlRpc::XmlRpcValue& value);

/// Everything under the handle's namespace.
ParameterMap read_parameters(const ros::NodeHandle& node);

/// Takes keys out of a list one by one, so that what nobody took is known in the end.
class KeyReader
{
public:
  explicit KeyReader(ParameterMap parameters) : parameters_(std::move(parameters)) {}

  // Each throws ConfigError naming the key when it is missing, has another type, or is out of range.
  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& fallback);
  double number(const std::string& key, double min, double max, const std::string& unit);
  double number(const std::string& key, double min, double max, const std::string& unit, double fallback);
  int count(const std::string& key, int min, int max, const std::string& unit);
  bool flag(const std::string& key);
  /// The name of a tf frame.
  std::string frame(const std::string& key);

  /// What `read` makes of all keys below `name/`, without that prefix; its ConfigErrors name the group, too.
  template <class Read>
  auto group(const std::string& name, Read read)
  {
    const ParameterMap members = take_group(name);
    try
    {
      return read(members);
    }
    catch (const ConfigError& error)
    {
      throw ConfigError("in '" + name + "': " + error.what());
    }
  }
  /// Keys that may be there and are for somebody else.
  void ignore(const std::vector<std::string>& keys);
  /// Throws ConfigError naming the first key that nobody took.
  void finish() const;

private:
  bool has(const std::string& key) const { return parameters_.count(key) != 0; }
  ParameterValue take(const std::string& key);
  ParameterMap take_group(const std::string& name);

  ParameterMap parameters_;
  std::vector<std::string> known_;
};

/// The whole private namespace of the planner's node: its own keys, `robot/...` and `planner/...`. Throws ConfigError.
GlobalPlannerParameters global_planner_parameters_from(const ParameterMap& parameters);

}  // namespace fourwis
