#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "parameter_laws.h"

namespace fourwis
{

const std::string kRobotFile = FOURWIS_SOURCE_DIR "/config/robot.yaml";
const std::string kPlannerFile = FOURWIS_SOURCE_DIR "/config/planner.yaml";

/// The wheels stay within the body.
ParameterMap with_fitting_wheels(ParameterMap parameters, const std::string& key, const ParameterValue& value)
{
  const auto number = [&](const char* of) -> double& { return std::get<double>(parameters[of]); };
  parameters[key] = value;
  for (const auto& [axis, side] : {std::pair("wheelbase", "length"), std::pair("track_width", "width")})
  {
    if (key == side) number(axis) = std::max(0.01, std::min(number(axis), number(side)));
    if (key == axis) number(side) = std::min(20.0, std::max(number(axis), number(side)));
  }
  return parameters;
}

template <>
Subject<Robot> subject_of()
{
  return {kRobotFile,
          robot_from,
          {{"length", [](const Robot& r) { return r.length; }, {0.05, 20.0}},
           {"width", [](const Robot& r) { return r.width; }, {0.05, 20.0}},
           {"wheelbase", [](const Robot& r) { return r.wheelbase; }, {0.01, 20.0}},
           {"track_width", [](const Robot& r) { return r.track_width; }, {0.01, 20.0}},
           {"max_steering_angle", [](const Robot& r) { return r.max_steering_angle; }, {0.01, M_PI * 80 / 180}},
           {"max_steering_rate", [](const Robot& r) { return r.max_steering_rate; }, {0.01, 100.0}},
           {"max_speed", [](const Robot& r) { return r.max_speed; }, {0.01, 20.0}},
           {"max_acceleration", [](const Robot& r) { return r.max_acceleration; }, {0.01, 50.0}},
           {"mode_switch_time", [](const Robot& r) { return r.mode_switch_time; }, {0.0, 60.0}},
           {"wheel_max_angle", [](const Robot& r) { return r.wheel_max_angle; }, {0.01, 10.0}},
           {"wheel_max_rate", [](const Robot& r) { return r.wheel_max_rate; }, {0.01, 100.0}},
           {"wheel_max_speed", [](const Robot& r) { return r.wheel_max_speed; }, {0.01, 50.0}},
           {"safety_margin", [](const Robot& r) { return r.safety_margin; }, {0.0, 1.0}},
           {"body_offset", [](const Robot& r) { return r.body_offset.x + 10.0 * r.body_offset.y; }},
           {"footprint", [](const Robot& r) { return double(r.footprint.size()); }},
           {"base_offset", [](const Robot& r) { return r.base_offset.x + 10.0 * r.base_offset.y; }}},
          with_fitting_wheels};
}

template <>
Subject<PlannerOptions> subject_of()
{
  using O = PlannerOptions;
  return {kPlannerFile,
          planner_options_from,
          {{"occupied_threshold", [](const O& o) { return double(o.obstacles.occupied_threshold); }, {1, 100, kWhole}},
           {"unknown_is_obstacle", [](const O& o) { return double(o.obstacles.unknown_is_obstacle); }},
           {"reference_speed", [](const O& o) { return o.search.reference_speed.value_or(-1.0); }, {0.01, 20.0}},
           {"step_time", [](const O& o) { return o.search.step_time.value_or(-1.0); }, {0.01, 10.0}},
           {"reverse_penalty", [](const O& o) { return o.search.reverse_penalty; }, {0.0, 1000.0}},
           {"lateral_reverse_penalty", [](const O& o) { return o.search.lateral_reverse_penalty; }, {0.0, 1000.0}},
           {"steering_penalty", [](const O& o) { return o.search.steering_penalty; }, {0.0, 1000.0}},
           {"parallel_steering_penalty", [](const O& o) { return o.search.parallel_steering_penalty; }, {0.0, 1000.0}},
           {"steering_change_penalty", [](const O& o) { return o.search.steering_change_penalty; }, {0.0, 1000.0}},
           {"direction_change_penalty", [](const O& o) { return o.search.direction_change_penalty; }, {0.0, 1e5}},
           {"heuristic_weight", [](const O& o) { return o.search.heuristic_weight; }, {0.0, 100.0}},
           {"terminal_connection", [](const O& o) { return double(o.search.terminal_connection); }},
           {"switching_awareness", [](const O& o) { return double(o.search.switching_awareness); }},
           {"xy_resolution", [](const O& o) { return o.search.xy_resolution.value_or(-1.0); }, {0.01, 5.0}},
           {"heading_resolution", [](const O& o) { return o.search.heading_resolution; }, {0.01, 1.6}},
           {"xy_goal_tolerance", [](const O& o) { return o.search.xy_goal_tolerance; }, {0.001, 5.0}},
           {"yaw_goal_tolerance", [](const O& o) { return o.search.yaw_goal_tolerance; }, {0.001, 3.15}},
           {"solver", [](const O& o) { return double(o.optimize.solver); }},
           {"formulation", [](const O& o) { return double(o.optimize.formulation); }},
           {"knot_spacing", [](const O& o) { return o.optimize.spacing.value_or(-1.0); }, {0.01, 2.0}},
           {"steering_comfort", [](const O& o) { return o.optimize.steering_comfort; }, {0.0, 100.0}},
           {"interval_weight", [](const O& o) { return o.optimize.interval_weight; }, {0.0, 100.0}},
           {"corridor_weight", [](const O& o) { return o.optimize.corridor_weight; }, {1.0, 1e6}},
           {"shortest_interval", [](const O& o) { return o.optimize.shortest_interval; }, {0.01, 0.9}},
           {"longest_interval", [](const O& o) { return o.optimize.longest_interval; }, {1.1, 100.0}},
           {"longest_at_rest", [](const O& o) { return o.optimize.longest_at_rest; }, {2.0, 100.0}},
           {"corridor_discs", [](const O& o) { return o.optimize.corridor_discs; }, {1, 8, kWhole}},
           {"polish_discs", [](const O& o) { return o.optimize.polish_discs; }, {1, 8, kWhole}},
           {"corridor_range", [](const O& o) { return o.optimize.corridor_range.value_or(-1.0); }, {0.1, 20.0}},
           {"outer_iterations", [](const O& o) { return double(o.optimize.outer_iterations); }, {1, 20, kWhole}},
           {"repairs", [](const O& o) { return double(o.optimize.repairs); }, {0, 20, kWhole}},
           {"shortcut_passes", [](const O& o) { return double(o.search.shortcut_passes); }, {0, 1000, kWhole}},
           {"max_expansions", [](const O& o) { return double(o.search.max_expansions); }, {1, 1e9, kWhole}},
           {"start_tolerance", [](const O& o) { return o.referee.start_tolerance; }, {0.0, 0.5}},
           {"collision_step", [](const O& o) { return o.referee.collision_step; }, {0.0005, 0.01}},
           {"planner_patience", [](const O& o) { return o.planner_patience; }, {0.001, 3600.0}}},
          with,
          {{"reference_speed", 1.0},
           {"step_time", 0.5},
           {"xy_resolution", 0.2},
           {"knot_spacing", 0.2},
           {"corridor_range", 2.0}}};
}

INSTANTIATE_TYPED_TEST_SUITE_P(RobotFile, ParameterLaws, Robot);
INSTANTIATE_TYPED_TEST_SUITE_P(PlannerFile, ParameterLaws, PlannerOptions);

TEST(Parameters, FractionIsRejectedWhereAWholeNumberIsExpected)
{
  const ParameterMap shipped = read_parameter_file(kPlannerFile);
  for (const std::string key : {"occupied_threshold", "shortcut_passes", "max_expansions"})
  {
    const std::string text = complaint(planner_options_from, with(shipped, key, 50.5));
    EXPECT_TRUE(contains(text, "'" + key + "' is 50.5, expected a whole number from ")) << text;
  }
}

TEST(Parameters, RangeEndsAreAllowed)
{
  const ParameterMap robot = read_parameter_file(kRobotFile), planner = read_parameter_file(kPlannerFile);
  EXPECT_EQ(robot_from(with(robot, "mode_switch_time", 0.0)).mode_switch_time, 0.0);
  EXPECT_EQ(robot_from(with(robot, "max_steering_angle", M_PI * 80 / 180)).max_steering_angle, M_PI * 80 / 180);
  EXPECT_EQ(planner_options_from(with(planner, "occupied_threshold", 1.0)).obstacles.occupied_threshold, 1);
  EXPECT_EQ(planner_options_from(with(planner, "occupied_threshold", 100.0)).obstacles.occupied_threshold, 100);
}

TEST(Parameters, WheelsOutsideTheBodyAreRejected)
{
  const ParameterMap shipped = read_parameter_file(kRobotFile);
  for (const auto& [axis, side] : {std::pair("wheelbase", "length"), std::pair("track_width", "width")})
  {
    const double extent = std::get<double>(shipped.at(side));
    EXPECT_EQ(complaint(robot_from, with(shipped, axis, extent)), "");
    const std::string text = complaint(robot_from, with(shipped, axis, extent + 0.01));
    EXPECT_TRUE(contains(text, axis) && contains(text, side)) << text;
  }
}

}  // namespace fourwis
