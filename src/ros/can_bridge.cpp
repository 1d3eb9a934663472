#include "can_bridge.h"

#include <algorithm>
#include <cmath>

#include <ros/console.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

#include "drive_conversions.h"
#include "fourwis_navigation/can/bus/real_time.h"
#include "stamps.h"

namespace fourwis
{
namespace
{

using can::BridgeStage;
using can::BridgeUpdate;

/// Beyond the drives' own timeouts [s].
constexpr double kReserve = 1.0;
/// How long the publisher waits for a cycle before it looks whether it is to end [s].
constexpr double kPatience = 0.2;

/// So that a release of the emergency stop does not push out its press.
constexpr std::uint32_t kEmergencyStopQueue = 100;

bool is_enabling(BridgeStage stage)
{
  return stage == BridgeStage::enabling || stage == BridgeStage::home;
}

}  // namespace

CanBridge::CanBridge(const CanBridgeParameters& parameters)
  : options_(parameters.bridge),
    bridge_(parameters.robot, options_, can::open_bus(options_.interface), parameters.node.real_time_priority),
    topics_(parameters.robot, parameters.node.frames),
    diagnostics_(monitor_, options_.interface)
{
  if (!bridge_.complaint().empty()) ROS_WARN("%s", bridge_.complaint().c_str());
  advertise("enable", [this] { return enable(); });
  advertise("disable", [this] { return disable(); });
  advertise("clear_faults", [this] { return bridge_.clear_faults(); });
  subscribe();
  publisher_ = std::thread([this] { publish_updates(); });
}

void CanBridge::subscribe()
{
  ros::NodeHandle node;
  node.setCallbackQueue(&command_queue_);
  const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
  // A queue of one: an older command is worth nothing.
  commands_ = node.subscribe<fourwis_navigation::WheelCommands>(
      "wheel_commands", 1, [this](const fourwis_navigation::WheelCommandsConstPtr& message) { on_command(*message); },
      nullptr, hints);
  emergency_stop_ = node.subscribe<std_msgs::Bool>(
      "emergency_stop", kEmergencyStopQueue,
      [this](const std_msgs::BoolConstPtr& message) { bridge_.press_emergency_stop(message->data); }, nullptr, hints);
  command_spinner_.start();
}

CanBridge::~CanBridge()
{
  end_ = true;
  publisher_.join();
}

void CanBridge::end()
{
  {
    const std::lock_guard<std::mutex> lock(enabling_);
    ending_ = true;
  }
  stop();
}

void CanBridge::stop()
{
  bridge_.disable();
  monitor_.wait_for([](const BridgeUpdate& update) { return update.report.out_of_operation; },
                    options_.stop_timeout + options_.enable_timeout + kReserve);
}

void CanBridge::on_command(const fourwis_navigation::WheelCommands& message)
{
  // In seconds: the difference of two wild stamps is more than a ros::Duration holds, which throws.
  const double age = message.header.stamp.isZero() ? 0.0 : ros::Time::now().toSec() - message.header.stamp.toSec();
  if (std::abs(age) <= options_.command_timeout) return bridge_.command(to_command(message), std::max(age, 0.0));
  diagnostics_.late_command();
  ROS_WARN_THROTTLE(1.0, "wheel_commands: %.3f s old, not taken", age);
}

void CanBridge::publish_updates()
{
  for (BridgeUpdate update; !end_;)
  {
    if (!bridge_.wait(update, kPatience)) continue;
    monitor_.put(update);
    publish(update);
  }
}

void CanBridge::publish(const BridgeUpdate& update)
{
  const ros::Time now = ros::Time::now();
  if (now.isZero())
  {
    ROS_WARN_ONCE("/use_sim_time is set and nothing came on /clock: nothing is published before");
    return;
  }
  const double age = can::monotonic_now() - update.wheels.stamp;
  // Older than the clock's beginning, or never measured: no stamp.
  const bool has_stamp = update.wheels.stamp > 0.0 && now.toSec() > age;
  // Without anything new from the wheels there is no odometry, but still a state to be told: it keeps its old stamp.
  const bool is_new = has_stamp && update.wheels.stamp > measured_;
  if (is_new) measured_ = update.wheels.stamp, stamp_ = in_order(stamp_, now - ros::Duration(age));
  topics_.set_silence({!is_new, false});
  topics_.publish(stamp_, update.wheels, explanation(update.report));
}

std::string CanBridge::enable()
{
  const std::string refusal = ask_to_enable();
  const can::BridgeReport before = monitor_.newest().report;
  if (!refusal.empty())
    return before.stage == BridgeStage::fault ? refusal + " (" + explanation(before) + ")" : refusal;
  const double patience = options_.enable_timeout + (options_.homing ? options_.homing_timeout : 0.0) + kReserve;
  monitor_.wait_for([](const BridgeUpdate& update) { return !is_enabling(update.report.stage); }, patience);
  return explanation(monitor_.newest().report);
}

/// What is accepted here has been accepted before the node begins to end.
std::string CanBridge::ask_to_enable()
{
  const std::lock_guard<std::mutex> lock(enabling_);
  return ending_ ? "the node is ending" : bridge_.enable();
}

std::string CanBridge::disable()
{
  stop();
  const can::BridgeReport report = monitor_.newest().report;
  return report.out_of_operation ? "" : explanation(report);
}

void CanBridge::advertise(const std::string& name, const std::function<std::string()>& action)
{
  using std_srvs::Trigger;
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> serve = [action](Trigger::Request&,
                                                                                      Trigger::Response& response) {
    response.message = action();
    response.success = response.message.empty();
    return true;
  };
  services_.push_back(ros::NodeHandle("~").advertiseService(name, serve));
}

}  // namespace fourwis
