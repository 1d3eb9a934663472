#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include "base_topics.h"
#include "bridge_diagnostics.h"
#include "fourwis_navigation/WheelCommands.h"
#include "fourwis_navigation/parameters/node_parameters.h"

namespace fourwis
{

/// The bridge's node: `wheel_commands`, `emergency_stop` and the services `~enable`, `~disable`, `~clear_faults` to the
/// drives; what the wheels do to `wheel_states`, `odom`, `joint_states` and `/diagnostics`. Both topics that it subscribes to
/// have a thread of their own; spin the rest with two: services wait for the drives.
class CanBridge
{
public:
  explicit CanBridge(const CanBridgeParameters& parameters);
  ~CanBridge();

  /// From now on nothing is enabled any more. Comes to rest and disables the drives; returns when that is done or has
  /// taken too long.
  void end();

private:
  void subscribe();
  void on_command(const fourwis_navigation::WheelCommands& message);
  void publish_updates();
  void publish(const can::BridgeUpdate& update);
  void stop();
  std::string enable();
  std::string ask_to_enable();
  std::string disable();
  void advertise(const std::string& name, const std::function<std::string()>& action);

  const can::BridgeOptions options_;
  BridgeMonitor monitor_;
  can::BridgeThread bridge_;
  BaseTopics topics_;
  BridgeDiagnostics diagnostics_;
  std::vector<ros::ServiceServer> services_;
  ros::CallbackQueue command_queue_;
  ros::Subscriber commands_, emergency_stop_;
  ros::AsyncSpinner command_spinner_{1, &command_queue_};
  double measured_ = 0.0;  ///< when what was published last was measured, monotonic [s]
  ros::Time stamp_;        ///< the same as it was published; zero: nothing has been measured yet
  std::mutex enabling_;
  bool ending_ = false;  ///< guarded by `enabling_`
  std::atomic<bool> end_{false};
  std::thread publisher_;
};

}  // namespace fourwis
