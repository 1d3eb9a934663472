#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/bus/real_time.h"
#include "fourwis_navigation/map/octomap_projection.h"
#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/option_text.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// How the name of a tf frame is written (model/option_text.h).
struct FrameName
{
  std::string expected() const { return "the name of a tf frame, without a leading slash"; }
  std::string write(const std::string& frame) const { return frame; }
  bool read(const std::string& text, std::string& frame) const
  {
    frame = text;
    return !text.empty() && text.front() != '/';
  }
};

/// How a set of modes is written.
struct ModeNames
{
  std::string expected() const
  {
    return "names out of " + planned_mode_names(", ", " and ") + " with commas between them";
  }
  std::string write(const ModeSet& modes) const
  {
    std::string text;
    for (const Mode mode : kPlannedModes)
      if (modes.contains(mode)) text += (text.empty() ? "" : ",") + std::string(to_string(mode));
    return text;
  }
  bool read(const std::string& text, ModeSet& modes) const
  {
    modes = ModeSet::none();
    std::istringstream names(text);
    for (std::string name; std::getline(names, name, ',');)
    {
      const auto mode = mode_from_string(name);
      if (!mode) return false;
      modes.insert(*mode);
    }
    return !modes.empty();
  }
};

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

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("global_frame", o.global_frame, FrameName{});
    row("robot_base_frame", o.robot_base_frame, FrameName{});
    row("transform_tolerance", o.transform_tolerance, 0.01, 60.0, "s");
    row("start_from", o.start_from, OneOf{"tf", "initialpose"});
    row("modes", o.modes, ModeNames{});
    row("wait_for_controller", o.wait_for_controller);
    row("controller_patience", o.controller_patience, 0.1, 60.0, "s");
    row("replan_attempts", o.replan_attempts, 0, 100, "attempts");
    row("start_delay", o.start_delay, 0.0, 10.0, "s");
    row("stop_delay", o.stop_delay, 0.0, 0.5, "s");
    row("show_expansions", o.show_expansions);
    row("show_corridors", o.show_corridors);
    row("show_iterations", o.show_iterations);
  }
};

/// The keys of `config/mpc_controller.yaml`, in the private namespace of mpc_controller_node.
struct MpcControllerOptions
{
  std::string global_frame = "map";            ///< frame of the trajectories
  std::string robot_base_frame = "base_link";  ///< the robot's centre; child_frame_id of `odom`
  double transform_tolerance = 0.5;            ///< how much older than odom the localisation's transform may be [s]
  bool require_permit = true;  ///< whether it drives only with permits; false where trajectories come without

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("global_frame", o.global_frame, FrameName{});
    row("robot_base_frame", o.robot_base_frame, FrameName{});
    row("transform_tolerance", o.transform_tolerance, 0.01, 60.0, "s");
    row("require_permit", o.require_permit);
  }
};

/// What a base calls its frames, and whether it publishes the transform between them.
struct BaseFrames
{
  std::string odom_frame = "odom";
  std::string robot_base_frame = "base_link";
  bool publish_odom_tf = true;
  double wheel_radius = 0.1;  ///< for the picture of turning wheels only [m]

  /// The table of the options but `wheel_radius`, which is a bridge's where there is one; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("odom_frame", o.odom_frame, FrameName{});
    row("robot_base_frame", o.robot_base_frame, FrameName{});
    row("publish_odom_tf", o.publish_odom_tf);
  }
};

/// The keys of `config/can_bridge_node.yaml`, in the private namespace of can_bridge_node.
struct CanBridgeNodeOptions
{
  BaseFrames frames;
  int real_time_priority = 50;  ///< of the thread that talks to the bus; 0: an ordinary thread

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row.group("", o.frames);
    row("real_time_priority", o.real_time_priority, 0, can::kHighestPriority);
  }
};

/// The simulated base without a bus.
inline const std::string kDirect = "direct";

/// The keys of `config/base_simulator.yaml`, in the private namespace of base_simulator_node.
struct BaseSimulatorNodeOptions
{
  std::string bus = kDirect;  ///< `direct`: takes wheel_commands itself; else drives on this bus, see can::open_bus()
  std::string global_frame = "map";
  BaseFrames frames;
  double publish_frequency = 100.0;  ///< cycles of simulated time each second; with a bus, of the true pose [Hz]
  double transform_tolerance = 0.1;  ///< how far ahead the ideal localisation dates its transform [s]
  bool publish_clock = true;         ///< without a bus: whether its time is that of all nodes
  double real_time_factor = 1.0;     ///< then: how much faster than real time
  double lockstep_period = 0.02;     ///< then: time waits for commands younger than this [s]; 0: never
  Pose initial;                      ///< where the robot is at first

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("bus", o.bus, Word{});
    row("global_frame", o.global_frame, FrameName{});
    row.group("", o.frames);
    row("wheel_radius", o.frames.wheel_radius, can::kWheelRadii.least, can::kWheelRadii.greatest,
        can::kWheelRadii.unit);
    row("publish_frequency", o.publish_frequency, 1.0, 1000.0, "Hz");
    row("transform_tolerance", o.transform_tolerance, 0.0, 10.0, "s");
    row("publish_clock", o.publish_clock);
    row("real_time_factor", o.real_time_factor, 0.01, 1000.0);
    row("lockstep_period", o.lockstep_period, 0.0, 1.0, "s");
    row("initial_x", o.initial.x, -1e6, 1e6, "m");
    row("initial_y", o.initial.y, -1e6, 1e6, "m");
    row("initial_yaw", o.initial.theta, -2.0 * M_PI, 2.0 * M_PI, "rad");
  }
};

/// Throws std::invalid_argument, naming key, value and what was expected, where one is out of range, or time is to pass
/// faster where it is not ours.
void check(const BaseSimulatorNodeOptions& options);

/// What map_publisher_node is configured with, in its private namespace.
struct MapPublisherOptions
{
  std::string map_file;  ///< map_server's YAML, perhaps "~/..."; the node's first argument stands in for a missing key
  std::string frame_id = "map";

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("map_file", o.map_file, Word{});
    row("frame_id", o.frame_id, Word{});
  }
};

/// What octomap_projector_node is configured with, in its private namespace.
struct OctomapProjectorOptions
{
  std::string octomap_file;  ///< .bt or .ot, perhaps "~/..."
  HeightBand band;
  std::string frame_id = "map";

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("octomap_file", o.octomap_file, Word{});
    row.group("", o.band);
    row("frame_id", o.frame_id, Word{});
  }
};

}  // namespace fourwis
