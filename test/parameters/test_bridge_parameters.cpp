#include <array>
#include <string>

#include <gtest/gtest.h>

#include "../support/sentences.h"
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
    bindings.push_back({s + "/node", [i](const O& o) { return double(o.steering[i].node); }, {1, 127, kWhole}});
    bindings.push_back({s + "/counts_per_turn", [i](const O& o) { return o.steering[i].counts_per_turn; }, {1.0, 1e9}});
    bindings.push_back({s + "/gear_ratio", [i](const O& o) { return o.steering[i].gear_ratio; }, {1e-3, 1e4}});
    bindings.push_back({s + "/reversed", [i](const O& o) { return double(o.steering[i].reversed); }});
    bindings.push_back({s + "/offset", [i](const O& o) { return o.steering[i].offset; }, {-10.0, 10.0}});
    bindings.push_back({d + "/node", [i](const O& o) { return double(o.driving[i].node); }, {1, 127, kWhole}});
    bindings.push_back({d + "/counts_per_turn", [i](const O& o) { return o.driving[i].counts_per_turn; }, {1.0, 1e9}});
    bindings.push_back({d + "/gear_ratio", [i](const O& o) { return o.driving[i].gear_ratio; }, {1e-3, 1e4}});
    bindings.push_back({d + "/reversed", [i](const O& o) { return double(o.driving[i].reversed); }});
    bindings.push_back(
        {"ranger/place/" + names[i], [i](const O& o) { return double(o.ranger.place[i]); }, {1, 4, kWhole}});
  }
  return bindings;
}

template <>
Subject<BridgeOptions> subject_of()
{
  using O = BridgeOptions;
  Subject<O> subject{
      kBridgeFile,
      bridge_options_from,
      {{"interface", [](const O& o) { return double(o.interface == "can0"); }},
       {"protocol", [](const O& o) { return double(o.protocol); }},
       {"bit_rate", [](const O& o) { return double(o.bit_rate); }, {10000, 1000000, kWhole}},
       {"cycle_time", [](const O& o) { return o.cycle_time; }, {0.001, 0.1}},
       {"master_node", [](const O& o) { return double(o.master_node); }, {1, 127, kWhole}},
       {"wheel_radius", [](const O& o) { return o.wheel_radius; }, {0.01, 2.0}},
       {"steering_mode", [](const O& o) { return double(o.steering_mode); }},
       {"driving_mode", [](const O& o) { return double(o.driving_mode); }},
       {"vendor_id", [](const O& o) { return double(o.vendor_id); }, {0.0, 4294967295.0, kWhole}},
       {"product_code", [](const O& o) { return double(o.product_code); }, {0.0, 4294967295.0, kWhole}},
       {"temperature_object", [](const O& o) { return double(o.temperature_object); }, {0.0, 16777215.0, kWhole}},
       {"temperature_unit", [](const O& o) { return o.temperature_unit; }, {0.001, 100.0}},
       {"homing", [](const O& o) { return double(o.homing); }},
       {"homing_method", [](const O& o) { return double(o.homing_method); }, {-128, 127, kWhole}},
       {"ranger/side_slip_mode", [](const O& o) { return double(o.ranger.side_slip_mode); }, {3, 255, kWhole}},
       {"ranger/spin_by_speed", [](const O& o) { return double(o.ranger.spin_by_speed); }},
       {"max_acceleration", [](const O& o) { return o.max_acceleration; }, {0.01, 1000.0}},
       {"stop_deceleration", [](const O& o) { return o.stop_deceleration; }, {0.1, 1000.0}},
       {"standstill_speed", [](const O& o) { return o.standstill_speed; }, {1e-4, 1.0}},
       {"standstill_time", [](const O& o) { return o.standstill_time; }, {0.0, 10.0}},
       {"aligned_tolerance", [](const O& o) { return o.aligned_tolerance; }, {1e-3, 0.5}},
       {"aligned_time", [](const O& o) { return o.aligned_time; }, {0.0, 10.0}},
       {"command_timeout", [](const O& o) { return o.command_timeout; }, {0.01, 10.0}},
       {"heartbeat_period", [](const O& o) { return o.heartbeat_period; }, {0.005, 1.0}},
       {"heartbeat_timeout", [](const O& o) { return o.heartbeat_timeout; }, {0.01, 10.0}},
       {"drive_watchdog", [](const O& o) { return o.drive_watchdog; }, {0.01, 10.0}},
       {"feedback_timeout", [](const O& o) { return o.feedback_timeout; }, {0.002, 10.0}},
       {"boot_timeout", [](const O& o) { return o.boot_timeout; }, {0.1, 600.0}},
       {"sdo_timeout", [](const O& o) { return o.sdo_timeout; }, {0.01, 60.0}},
       {"enable_timeout", [](const O& o) { return o.enable_timeout; }, {0.1, 600.0}},
       {"homing_timeout", [](const O& o) { return o.homing_timeout; }, {0.1, 3600.0}},
       {"alignment_timeout", [](const O& o) { return o.alignment_timeout; }, {0.1, 600.0}},
       {"stop_timeout", [](const O& o) { return o.stop_timeout; }, {0.1, 600.0}},
       {"following_time", [](const O& o) { return o.following_time; }, {0.01, 10.0}},
       {"steering_error", [](const O& o) { return o.steering_error; }, {0.01, 3.0}},
       {"speed_error", [](const O& o) { return o.speed_error; }, {0.01, 100.0}}}};
  for (const Binding<O>& binding : axis_bindings()) subject.bindings.push_back(binding);
  return subject;
}

INSTANTIATE_TYPED_TEST_SUITE_P(BridgeFile, ParameterLaws, BridgeOptions);

TEST(BridgeParameters, MakeABridge)
{
  EXPECT_NO_THROW(can::Bridge(Robot(), read_bridge_file(kBridgeFile)));
}

TEST(BridgeParameters, AWordThatIsNoneOfTheFewIsRejectedAndTheFewAreNamed)
{
  const ParameterMap shipped = read_parameter_file(kBridgeFile);
  EXPECT_EQ(complaint(bridge_options_from, with(shipped, "protocol", std::string("modbus"))),
            "parameter 'protocol' is 'modbus', expected one of cia402, ranger");
}

TEST(BridgeParameters, OptionsOutOfRangeAreRejectedByName)
{
  const auto said = [](auto change) {
    BridgeOptions options;
    change(options);
    return error_of<std::invalid_argument>([&] { can::Bridge(Robot(), options); });
  };
  EXPECT_TRUE(says(said([](BridgeOptions& o) { o.steering[1].node = 0; }),
                   "'steering/front_right/node' is 0, expected a whole number from 1 to 127"));
  EXPECT_TRUE(
      says(said([](BridgeOptions& o) { o.driving[3].gear_ratio = NAN; }), "'driving/rear_right/gear_ratio' is nan"));
  EXPECT_TRUE(says(said([](BridgeOptions& o) { o.steering[2].offset = 11.0; }), "'steering/rear_left/offset' is 11"));
  EXPECT_TRUE(says(said([](BridgeOptions& o) { o.ranger.place[0] = 5; }), "'ranger/place/front_left' is 5"));
  EXPECT_TRUE(
      says(said([](BridgeOptions& o) { o.temperature_object = 16777216; }), "'temperature_object' is 16777216"));
  EXPECT_TRUE(says(said([](BridgeOptions& o) { o.protocol = static_cast<can::Protocol>(2); }),
                   "'protocol' is '', expected one of cia402, ranger"));
  EXPECT_TRUE(says(said([](BridgeOptions& o) { o.interface.clear(); }), "'interface' is '', expected a word"));
  Robot robot;
  robot.wheel_max_rate = 0.0;
  EXPECT_TRUE(says(error_of<std::invalid_argument>([&] { can::Bridge(robot, {}); }), "'wheel_max_rate' is 0"));
}

TEST(BridgeParameters, OptionsThatContradictEachOtherAreRejected)
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
  const auto too_many_counts = [](auto change) {
    BridgeOptions options;
    change(options);
    const std::string text = error_of<std::invalid_argument>([&] { can::Bridge(Robot(), options); });
    EXPECT_TRUE(says(text, "more than 32 bits"));
  };
  too_many_counts([](BridgeOptions& o) {
    o.steering[2].counts_per_turn = 131072.0, o.steering[2].gear_ratio = 1e4, o.steering[2].offset = 10.0;
  });
  too_many_counts([](BridgeOptions& o) {
    o.driving[2].counts_per_turn = 131072.0, o.driving[2].gear_ratio = 1e4;
    o.max_acceleration = o.stop_deceleration = 1.0;
  });
  too_many_counts([](BridgeOptions& o) { o.driving[2].gear_ratio = 50.0, o.stop_deceleration = 1000.0; });
}

TEST(BridgeParameters, OptionsThatContradictTheRobotAreRejectedWithBothKeys)
{
  const auto said = [](auto change) {
    Robot robot;
    BridgeOptions options;
    change(robot, options);
    return error_of<std::invalid_argument>([&] { can::Bridge(robot, options); });
  };
  const std::string late = said([](Robot& r, BridgeOptions&) { r.wheel_max_rate = 0.4; });
  EXPECT_TRUE(says(late, "'alignment_timeout' is 3, expected at least 9.04 s"));
  EXPECT_TRUE(says(late, "'wheel_max_rate' is 0.4 rad/s"));
  EXPECT_EQ(said([](Robot& r, BridgeOptions& o) { r.wheel_max_rate = 0.4, o.alignment_timeout = 9.04; }), "");
  EXPECT_TRUE(says(said([](Robot&, BridgeOptions& o) { o.aligned_time = 2.0; }), "'alignment_timeout' is 3"));

  EXPECT_TRUE(says(said([](Robot&, BridgeOptions& o) { o.protocol = can::Protocol::ranger; }),
                   "'wheel_max_angle' is 2.792526803190927, expected at most 1.5708 rad where 'protocol' is 'ranger'"));
  EXPECT_EQ(said([](Robot& r, BridgeOptions& o) { r.wheel_max_angle = M_PI_2, o.protocol = can::Protocol::ranger; }),
            "");

  EXPECT_TRUE(says(said([](Robot& r, BridgeOptions&) { r.max_acceleration = 12.1; }),
                   "'max_acceleration' is 12, expected at least 'max_acceleration' of the robot (12.1 m/s^2)"));
  EXPECT_EQ(said([](Robot& r, BridgeOptions&) { r.max_acceleration = 12.0; }), "");

  const std::string rolls_on = said([](Robot&, BridgeOptions& o) { o.stop_deceleration = 0.5; });
  EXPECT_TRUE(says(rolls_on, "'stop_timeout' is 3, expected at least 4.1"));
  EXPECT_TRUE(says(rolls_on, "'wheel_max_speed' is 2 m/s and 'stop_deceleration' 0.5 m/s^2"));

  const auto slow_homing = [](Robot& r, BridgeOptions& o) { r.wheel_max_rate = 2.0, o.homing = true; };
  EXPECT_TRUE(says(said(slow_homing), "'homing_timeout' is 20, expected at least 27.93 s"));
  EXPECT_TRUE(says(said(slow_homing), "'wheel_max_rate' (2 rad/s)"));
  EXPECT_EQ(said([](Robot& r, BridgeOptions&) { r.wheel_max_rate = 2.0; }), "") << "no homing";
}

}  // namespace fourwis
