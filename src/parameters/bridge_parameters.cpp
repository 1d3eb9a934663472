#include <array>
#include <string>

#include "parameter_table.h"

namespace fourwis
{
namespace
{

using can::AxisOptions;
using can::BridgeOptions;
using can::RangerOptions;
using can::WheelAxes;
using Table = ParameterTable<BridgeOptions>;

constexpr std::array<const char*, kWheels> kWheelNames = {"front_left", "front_right", "rear_left", "rear_right"};

template <class Value>
auto bridge(Value BridgeOptions::*member)
{
  return [member](BridgeOptions& options) -> Slot { return &(options.*member); };
}

template <class Value>
auto one_of(Value BridgeOptions::*member, const std::vector<std::string>& words)
{
  return [member, words](BridgeOptions& options) -> Slot { return choice(options.*member, words); };
}

void add_protocol(Table& table)
{
  table.push_back({"interface", bridge(&BridgeOptions::interface)});
  table.push_back({"protocol", one_of(&BridgeOptions::protocol, {"cia402", "ranger"})});
  table.push_back({"bit_rate", bridge(&BridgeOptions::bit_rate), 10000, 1000000, "bit/s"});
  table.push_back({"cycle_time", bridge(&BridgeOptions::cycle_time), 0.001, 0.1, "s"});
  table.push_back({"master_node", bridge(&BridgeOptions::master_node), 1, 127});
}

template <class Value>
auto axis(WheelAxes BridgeOptions::*axes, std::size_t wheel, Value AxisOptions::*member)
{
  return [=](BridgeOptions& options) -> Slot { return &((options.*axes)[wheel].*member); };
}

void add_axes(Table& table, const std::string& kind, WheelAxes BridgeOptions::*axes, bool steering)
{
  for (std::size_t wheel = 0; wheel < kWheels; ++wheel)
  {
    const std::string prefix = kind + "/" + kWheelNames[wheel] + "/";
    table.push_back({prefix + "node", axis(axes, wheel, &AxisOptions::node), 1, 127});
    table.push_back({prefix + "counts_per_turn", axis(axes, wheel, &AxisOptions::counts_per_turn), 1.0, 1e9, "counts"});
    table.push_back({prefix + "gear_ratio", axis(axes, wheel, &AxisOptions::gear_ratio), 1e-3, 1e4});
    table.push_back({prefix + "reversed", axis(axes, wheel, &AxisOptions::reversed)});
    if (steering) table.push_back({prefix + "offset", axis(axes, wheel, &AxisOptions::offset), -10.0, 10.0, "rad"});
  }
}

void add_drives(Table& table)
{
  add_axes(table, "steering", &BridgeOptions::steering, true);
  add_axes(table, "driving", &BridgeOptions::driving, false);
  table.push_back({"wheel_radius", bridge(&BridgeOptions::wheel_radius), 0.01, 2.0, "m"});
  table.push_back({"steering_mode", one_of(&BridgeOptions::steering_mode, {"cyclic", "profile"})});
  table.push_back({"driving_mode", one_of(&BridgeOptions::driving_mode, {"cyclic", "profile"})});
  table.push_back({"vendor_id", bridge(&BridgeOptions::vendor_id), 0.0, 4294967295.0});
  table.push_back({"product_code", bridge(&BridgeOptions::product_code), 0.0, 4294967295.0});
  table.push_back({"temperature_object", bridge(&BridgeOptions::temperature_object), 0.0, 16777215.0});
  table.push_back({"temperature_unit", bridge(&BridgeOptions::temperature_unit), 0.001, 100.0, "deg C"});
  table.push_back({"homing", bridge(&BridgeOptions::homing)});
  table.push_back({"homing_method", bridge(&BridgeOptions::homing_method), -128, 127});
}

void add_ranger(Table& table)
{
  for (std::size_t wheel = 0; wheel < kWheels; ++wheel)
    table.push_back({std::string("ranger/place/") + kWheelNames[wheel],
                     [wheel](BridgeOptions& options) -> Slot { return &options.ranger.place[wheel]; }, 1, kWheels});
  table.push_back(
      {"ranger/side_slip_mode", [](BridgeOptions& options) -> Slot { return &options.ranger.side_slip_mode; }, 0, 255});
  table.push_back(
      {"ranger/spin_by_speed", [](BridgeOptions& options) -> Slot { return &options.ranger.spin_by_speed; }});
}

void add_motion(Table& table)
{
  table.push_back({"max_acceleration", bridge(&BridgeOptions::max_acceleration), 0.01, 1000.0, "m/s^2"});
  table.push_back({"stop_deceleration", bridge(&BridgeOptions::stop_deceleration), 0.1, 1000.0, "m/s^2"});
  table.push_back({"standstill_speed", bridge(&BridgeOptions::standstill_speed), 1e-4, 1.0, "m/s"});
  table.push_back({"standstill_time", bridge(&BridgeOptions::standstill_time), 0.0, 10.0, "s"});
  table.push_back({"aligned_tolerance", bridge(&BridgeOptions::aligned_tolerance), 1e-3, 0.5, "rad"});
  table.push_back({"aligned_time", bridge(&BridgeOptions::aligned_time), 0.0, 10.0, "s"});
}

void add_watchdogs(Table& table)
{
  table.push_back({"command_timeout", bridge(&BridgeOptions::command_timeout), 0.01, 10.0, "s"});
  table.push_back({"heartbeat_period", bridge(&BridgeOptions::heartbeat_period), 0.005, 1.0, "s"});
  table.push_back({"heartbeat_timeout", bridge(&BridgeOptions::heartbeat_timeout), 0.01, 10.0, "s"});
  table.push_back({"drive_watchdog", bridge(&BridgeOptions::drive_watchdog), 0.01, 10.0, "s"});
  table.push_back({"feedback_timeout", bridge(&BridgeOptions::feedback_timeout), 0.002, 10.0, "s"});
  table.push_back({"boot_timeout", bridge(&BridgeOptions::boot_timeout), 0.1, 600.0, "s"});
  table.push_back({"sdo_timeout", bridge(&BridgeOptions::sdo_timeout), 0.01, 60.0, "s"});
  table.push_back({"enable_timeout", bridge(&BridgeOptions::enable_timeout), 0.1, 600.0, "s"});
  table.push_back({"homing_timeout", bridge(&BridgeOptions::homing_timeout), 0.1, 3600.0, "s"});
  table.push_back({"alignment_timeout", bridge(&BridgeOptions::alignment_timeout), 0.1, 600.0, "s"});
  table.push_back({"stop_timeout", bridge(&BridgeOptions::stop_timeout), 0.1, 600.0, "s"});
  table.push_back({"following_time", bridge(&BridgeOptions::following_time), 0.01, 10.0, "s"});
  table.push_back({"steering_error", bridge(&BridgeOptions::steering_error), 0.01, 3.0, "rad"});
  table.push_back({"speed_error", bridge(&BridgeOptions::speed_error), 0.01, 100.0, "m/s"});
}

const Table& bridge_table()
{
  static const Table table = [] {
    Table rows;
    add_protocol(rows);
    add_drives(rows);
    add_ranger(rows);
    add_motion(rows);
    add_watchdogs(rows);
    return rows;
  }();
  return table;
}

}  // namespace

BridgeOptions bridge_options_from(const ParameterMap& parameters)
{
  return options_from(bridge_table(), parameters);
}

}  // namespace fourwis
