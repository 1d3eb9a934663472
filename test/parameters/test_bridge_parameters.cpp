#include <array>
#include <string>

#include <gtest/gtest.h>

#include "fourwis_navigation/can/bridge/bridge.h"
#include "parameter_laws.h"

namespace fourwis
{

using can::BridgeOptions;

const std::string kBridgeFile = FOURWIS_SOURCE_DIR "/config/can_bridge.yaml";

/// The keys of the eight drives.
std::vector<Binding<BridgeOptions>> axis_bindings()
{
  using O = BridgeOptions;
  const std::array<std::string, kWheels> names = {"front_left", "front_right", "rear_left", "rear_right"};
  std::vector<Binding<O>> bindings;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const std::string s = "steering/" + names[i], d = "driving/" + names[i];
    bindings.push_back({s + "/node", [i](const O& o) { return double(o.steering[i].node); }});
    bindings.push_back({s + "/counts_per_turn", [i](const O& o) { return o.steering[i].counts_per_turn; }});
    bindings.push_back({s + "/gear_ratio", [i](const O& o) { return o.steering[i].gear_ratio; }});
    bindings.push_back({s + "/reversed", [i](const O& o) { return double(o.steering[i].reversed); }});
    bindings.push_back({s + "/offset", [i](const O& o) { return o.steering[i].offset; }});
    bindings.push_back({d + "/node", [i](const O& o) { return double(o.driving[i].node); }});
    bindings.push_back({d + "/counts_per_turn", [i](const O& o) { return o.driving[i].counts_per_turn; }});
    bindings.push_back({d + "/gear_ratio", [i](const O& o) { return o.driving[i].gear_ratio; }});
    bindings.push_back({d + "/reversed", [i](const O& o) { return double(o.driving[i].reversed); }});
    bindings.push_back({"ranger/place/" + names[i], [i](const O& o) { return double(o.ranger.place[i]); }});
  }
  return bindings;
}

template <>
Subject<BridgeOptions> subject_of()
{
  using O = BridgeOptions;
  Subject<O> subject{kBridgeFile,
                     bridge_options_from,
                     {{"interface", [](const O& o) { return double(o.interface == "can0"); }},
                      {"protocol", [](const O& o) { return double(o.protocol); }},
                      {"bit_rate", [](const O& o) { return double(o.bit_rate); }},
                      {"cycle_time", [](const O& o) { return o.cycle_time; }},
                      {"master_node", [](const O& o) { return double(o.master_node); }},
                      {"wheel_radius", [](const O& o) { return o.wheel_radius; }},
                      {"steering_mode", [](const O& o) { return double(o.steering_mode); }},
                      {"driving_mode", [](const O& o) { return double(o.driving_mode); }},
                      {"vendor_id", [](const O& o) { return o.vendor_id; }},
                      {"product_code", [](const O& o) { return o.product_code; }},
                      {"temperature_object", [](const O& o) { return o.temperature_object; }},
                      {"temperature_unit", [](const O& o) { return o.temperature_unit; }},
                      {"homing", [](const O& o) { return double(o.homing); }},
                      {"homing_method", [](const O& o) { return double(o.homing_method); }},
                      {"ranger/side_slip_mode", [](const O& o) { return double(o.ranger.side_slip_mode); }},
                      {"ranger/spin_by_speed", [](const O& o) { return double(o.ranger.spin_by_speed); }},
                      {"max_acceleration", [](const O& o) { return o.max_acceleration; }},
                      {"stop_deceleration", [](const O& o) { return o.stop_deceleration; }},
                      {"standstill_speed", [](const O& o) { return o.standstill_speed; }},
                      {"standstill_time", [](const O& o) { return o.standstill_time; }},
                      {"aligned_tolerance", [](const O& o) { return o.aligned_tolerance; }},
                      {"aligned_time", [](const O& o) { return o.aligned_time; }},
                      {"command_timeout", [](const O& o) { return o.command_timeout; }},
                      {"heartbeat_period", [](const O& o) { return o.heartbeat_period; }},
                      {"heartbeat_timeout", [](const O& o) { return o.heartbeat_timeout; }},
                      {"drive_watchdog", [](const O& o) { return o.drive_watchdog; }},
                      {"feedback_timeout", [](const O& o) { return o.feedback_timeout; }},
                      {"boot_timeout", [](const O& o) { return o.boot_timeout; }},
                      {"sdo_timeout", [](const O& o) { return o.sdo_timeout; }},
                      {"enable_timeout", [](const O& o) { return o.enable_timeout; }},
                      {"homing_timeout", [](const O& o) { return o.homing_timeout; }},
                      {"alignment_timeout", [](const O& o) { return o.alignment_timeout; }},
                      {"stop_timeout", [](const O& o) { return o.stop_timeout; }},
                      {"following_time", [](const O& o) { return o.following_time; }},
                      {"steering_error", [](const O& o) { return o.steering_error; }},
                      {"speed_error", [](const O& o) { return o.speed_error; }}}};
  for (const Binding<O>& binding : axis_bindings()) subject.bindings.push_back(binding);
  return subject;
}

INSTANTIATE_TYPED_TEST_SUITE_P(BridgeFile, ParameterLaws, BridgeOptions);

TEST(BridgeParameters, MakeABridge)
{
  EXPECT_NO_THROW(can::Bridge(Robot(), read_bridge_file(kBridgeFile)));
}

TEST(BridgeParameters, AWordThatIsNoneOfTheFewIsRefusedAndTheFewAreNamed)
{
  const ParameterMap shipped = read_parameter_file(kBridgeFile);
  EXPECT_EQ(complaint(bridge_options_from, with(shipped, "protocol", std::string("modbus"))),
            "parameter 'protocol' is 'modbus', expected one of cia402, ranger");
}

TEST(BridgeParameters, OptionsThatContradictEachOtherAreRefused)
{
  const auto refused = [](auto change) {
    BridgeOptions options;
    change(options);
    EXPECT_THROW(can::Bridge(Robot(), options), std::invalid_argument);
  };
  refused([](BridgeOptions& o) { o.driving[0].node = 1; });
  refused([](BridgeOptions& o) { o.master_node = 8; });
  refused([](BridgeOptions& o) { o.drive_watchdog = o.heartbeat_period; });
  refused([](BridgeOptions& o) { o.heartbeat_timeout = 0.01; });
  refused([](BridgeOptions& o) { o.ranger.place = {1, 1, 2, 3}; });
  refused([](BridgeOptions& o) { o.ranger.place = {0, 1, 2, 3}; });
  for (const int other : {0, 1, 2}) refused([=](BridgeOptions& o) { o.ranger.side_slip_mode = other; });
  refused([](BridgeOptions& o) { o.cycle_time = 0.0105; });
  refused([](BridgeOptions& o) { o.feedback_timeout = o.cycle_time; });
  // A heartbeat leaves with a cycle: 80 ms apart, and a cycle later where it is late.
  refused([](BridgeOptions& o) { o.cycle_time = 0.04, o.feedback_timeout = 0.1; });
  refused([](BridgeOptions& o) { o.heartbeat_timeout = 1.5 * o.heartbeat_period; });
  for (const int method : {0, 35, 37})
    refused([method](BridgeOptions& o) { o.homing = true, o.homing_method = method; });
  // Counts beyond 32 bits: of an angle, of a speed, of a deceleration.
  refused([](BridgeOptions& o) { o.steering[2].offset = 1e4; });
  refused([](BridgeOptions& o) { o.driving[2].gear_ratio = 40000.0; });
  refused([](BridgeOptions& o) { o.stop_deceleration = 3000.0; });
}

}  // namespace fourwis
