#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "parameter_laws.h"

namespace fourwis
{

const std::string kRobotFile = FOURWIS_SOURCE_DIR "/config/robot.yaml";
const std::string kPlannerFile = FOURWIS_SOURCE_DIR "/config/planner.yaml";

template <>
Subject<Robot> subject_of()
{
  return {kRobotFile,
          robot_from,
          {{"length", [](const Robot& r) { return r.length; }},
           {"width", [](const Robot& r) { return r.width; }},
           {"wheelbase", [](const Robot& r) { return r.wheelbase; }},
           {"track_width", [](const Robot& r) { return r.track_width; }},
           {"max_steering_angle", [](const Robot& r) { return r.max_steering_angle; }},
           {"max_steering_rate", [](const Robot& r) { return r.max_steering_rate; }},
           {"max_speed", [](const Robot& r) { return r.max_speed; }},
           {"max_acceleration", [](const Robot& r) { return r.max_acceleration; }},
           {"mode_switch_time", [](const Robot& r) { return r.mode_switch_time; }},
           {"wheel_max_angle", [](const Robot& r) { return r.wheel_max_angle; }},
           {"wheel_max_rate", [](const Robot& r) { return r.wheel_max_rate; }},
           {"wheel_max_speed", [](const Robot& r) { return r.wheel_max_speed; }},
           {"safety_margin", [](const Robot& r) { return r.safety_margin; }}}};
}

template <>
Subject<PlannerOptions> subject_of()
{
  using O = PlannerOptions;
  return {kPlannerFile,
          planner_options_from,
          {{"occupied_threshold", [](const O& o) { return double(o.obstacles.occupied_threshold); }},
           {"unknown_is_obstacle", [](const O& o) { return double(o.obstacles.unknown_is_obstacle); }},
           {"reference_speed", [](const O& o) { return o.search.reference_speed; }},
           {"step_time", [](const O& o) { return o.search.step_time; }},
           {"reverse_penalty", [](const O& o) { return o.search.reverse_penalty; }},
           {"lateral_reverse_penalty", [](const O& o) { return o.search.lateral_reverse_penalty; }},
           {"steering_penalty", [](const O& o) { return o.search.steering_penalty; }},
           {"parallel_steering_penalty", [](const O& o) { return o.search.parallel_steering_penalty; }},
           {"steering_change_penalty", [](const O& o) { return o.search.steering_change_penalty; }},
           {"direction_change_penalty", [](const O& o) { return o.search.direction_change_penalty; }},
           {"heuristic_weight", [](const O& o) { return o.search.heuristic_weight; }},
           {"terminal_connection", [](const O& o) { return double(o.search.terminal_connection); }},
           {"switching_awareness", [](const O& o) { return double(o.search.switching_awareness); }},
           {"xy_resolution", [](const O& o) { return o.search.xy_resolution; }},
           {"heading_resolution", [](const O& o) { return o.search.heading_resolution; }},
           {"xy_goal_tolerance", [](const O& o) { return o.search.xy_goal_tolerance; }},
           {"yaw_goal_tolerance", [](const O& o) { return o.search.yaw_goal_tolerance; }},
           {"solver", [](const O& o) { return double(o.optimize.solver); }},
           {"formulation", [](const O& o) { return double(o.optimize.formulation); }},
           {"knot_spacing", [](const O& o) { return o.optimize.spacing; }},
           {"steering_comfort", [](const O& o) { return o.optimize.steering_comfort; }},
           {"interval_weight", [](const O& o) { return o.optimize.interval_weight; }},
           {"corridor_weight", [](const O& o) { return o.optimize.corridor_weight; }},
           {"shortest_interval", [](const O& o) { return o.optimize.shortest_interval; }},
           {"longest_interval", [](const O& o) { return o.optimize.longest_interval; }},
           {"longest_at_rest", [](const O& o) { return o.optimize.longest_at_rest; }},
           {"corridor_discs", [](const O& o) { return o.optimize.corridor_discs; }},
           {"polish_discs", [](const O& o) { return o.optimize.polish_discs; }},
           {"corridor_range", [](const O& o) { return o.optimize.corridor_range; }},
           {"outer_iterations", [](const O& o) { return double(o.optimize.outer_iterations); }},
           {"repairs", [](const O& o) { return double(o.optimize.repairs); }},
           {"shortcut_passes", [](const O& o) { return double(o.search.shortcut_passes); }},
           {"max_expansions", [](const O& o) { return double(o.search.max_expansions); }},
           {"collision_step", [](const O& o) { return o.referee.collision_step; }},
           {"planner_patience", [](const O& o) { return o.planner_patience; }}}};
}

INSTANTIATE_TYPED_TEST_SUITE_P(RobotFile, ParameterLaws, Robot);
INSTANTIATE_TYPED_TEST_SUITE_P(PlannerFile, ParameterLaws, PlannerOptions);

TEST(Parameters, FractionIsRefusedWhereAWholeNumberIsExpected)
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

TEST(Parameters, WheelsOutsideTheBodyAreRefused)
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
