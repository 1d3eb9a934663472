#include "drive_parameters.h"

namespace fourwis
{
namespace
{

constexpr double kFarthest = 1e6;

MpcControllerOptions controller_options(KeyReader& reader)
{
  MpcControllerOptions options;
  options.global_frame = reader.frame("global_frame");
  options.robot_base_frame = reader.frame("robot_base_frame");
  options.transform_tolerance = reader.number("transform_tolerance", 0.01, 60.0, "s");
  return options;
}

void check_pace(const BaseSimulatorNodeOptions& options)
{
  const bool has_bus = options.bus != kDirect;
  if (options.real_time_factor == 1.0 || (!has_bus && options.publish_clock)) return;
  const std::string time = has_bus ? "'bus' is '" + options.bus + "': its drives live in real time"
                                   : "'publish_clock' is false: time is somebody else's";
  throw ConfigError("parameter 'real_time_factor' is " + std::to_string(options.real_time_factor) +
                    ", expected 1 where " + time);
}

BaseSimulatorNodeOptions simulator_options(KeyReader& reader)
{
  BaseSimulatorNodeOptions options;
  options.bus = reader.text("bus");
  options.global_frame = reader.frame("global_frame");
  options.frames = base_frames_from(reader);
  options.frames.wheel_radius = reader.number("wheel_radius", 0.01, 10.0, "m");
  options.publish_frequency = reader.number("publish_frequency", 1.0, 1000.0, "Hz");
  options.transform_tolerance = reader.number("transform_tolerance", 0.0, 10.0, "s");
  options.publish_clock = reader.flag("publish_clock");
  options.real_time_factor = reader.number("real_time_factor", 0.01, 1000.0, "");
  check_pace(options);
  options.lockstep_period = reader.number("lockstep_period", 0.0, 1.0, "s");
  options.initial.x = reader.number("initial_x", -kFarthest, kFarthest, "m");
  options.initial.y = reader.number("initial_y", -kFarthest, kFarthest, "m");
  options.initial.theta = reader.number("initial_yaw", -2.0 * M_PI, 2.0 * M_PI, "rad");
  return options;
}

}  // namespace

BaseFrames base_frames_from(KeyReader& reader)
{
  BaseFrames frames;
  frames.odom_frame = reader.frame("odom_frame");
  frames.robot_base_frame = reader.frame("robot_base_frame");
  frames.publish_odom_tf = reader.flag("publish_odom_tf");
  return frames;
}

MpcControllerParameters mpc_controller_parameters_from(const ParameterMap& parameters)
{
  KeyReader reader(parameters);
  MpcControllerParameters result;
  result.node = controller_options(reader);
  result.robot = reader.group("robot", robot_from);
  result.track = reader.group("mpc", track_options_from);
  reader.ignore({"diagnostic_period"});
  reader.finish();
  return result;
}

BaseSimulatorParameters base_simulator_parameters_from(const ParameterMap& parameters)
{
  KeyReader reader(parameters);
  BaseSimulatorParameters result;
  result.node = simulator_options(reader);
  result.robot = reader.group("robot", robot_from);
  result.simulator = reader.group("simulator", simulator_options_from);
  if (result.node.bus != kDirect) result.bridge = reader.group("can_bridge", bridge_options_from);
  reader.finish();
  return result;
}

}  // namespace fourwis
