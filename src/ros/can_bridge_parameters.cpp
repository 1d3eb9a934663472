#include "can_bridge_parameters.h"

namespace fourwis
{
namespace
{

CanBridgeNodeOptions node_options(KeyReader& reader)
{
  CanBridgeNodeOptions options;
  options.frames = base_frames_from(reader);
  options.real_time_priority = reader.count("real_time_priority", 0, 99, "");
  return options;
}

}  // namespace

CanBridgeParameters can_bridge_parameters_from(const ParameterMap& parameters)
{
  KeyReader reader(parameters);
  CanBridgeParameters result;
  result.node = node_options(reader);
  result.robot = reader.group("robot", robot_from);
  result.bridge = reader.group("can_bridge", bridge_options_from);
  result.node.frames.wheel_radius = result.bridge.wheel_radius;
  reader.ignore({"diagnostic_period"});
  reader.finish();
  return result;
}

}  // namespace fourwis
