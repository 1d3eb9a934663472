#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "fourwis_navigation/track/tracker.h"
#include "parameter_laws.h"

namespace fourwis
{

const std::string kTrackFile = FOURWIS_SOURCE_DIR "/config/mpc.yaml";

template <>
Subject<TrackOptions> subject_of()
{
  using O = TrackOptions;
  return {kTrackFile,
          track_options_from,
          {{"controller_frequency", [](const O& o) { return o.controller_frequency; }},
           {"horizon", [](const O& o) { return o.horizon; }},
           {"knots", [](const O& o) { return double(o.knots); }},
           {"lateral_scale", [](const O& o) { return o.lateral_scale; }},
           {"longitudinal_scale", [](const O& o) { return o.longitudinal_scale; }},
           {"heading_scale", [](const O& o) { return o.heading_scale; }},
           {"speed_scale", [](const O& o) { return o.speed_scale; }},
           {"steering_scale", [](const O& o) { return o.steering_scale; }},
           {"acceleration_scale", [](const O& o) { return o.acceleration_scale; }},
           {"steering_rate_scale", [](const O& o) { return o.steering_rate_scale; }},
           {"command_latency", [](const O& o) { return o.command_latency; }},
           {"drive_lag", [](const O& o) { return o.drive_lag; }},
           {"steering_lag", [](const O& o) { return o.steering_lag; }},
           {"xy_start_tolerance", [](const O& o) { return o.xy_start_tolerance; }},
           {"yaw_start_tolerance", [](const O& o) { return o.yaw_start_tolerance; }},
           {"xy_goal_tolerance", [](const O& o) { return o.xy_goal_tolerance; }},
           {"yaw_goal_tolerance", [](const O& o) { return o.yaw_goal_tolerance; }},
           {"xy_switch_tolerance", [](const O& o) { return o.xy_switch_tolerance; }},
           {"yaw_switch_tolerance", [](const O& o) { return o.yaw_switch_tolerance; }},
           {"max_xy_correction", [](const O& o) { return o.max_xy_correction; }},
           {"max_yaw_correction", [](const O& o) { return o.max_yaw_correction; }},
           {"correction_speed", [](const O& o) { return o.correction_speed; }},
           {"correction_timeout", [](const O& o) { return o.correction_timeout; }},
           {"settle_time", [](const O& o) { return o.settle_time; }},
           {"rest_speed", [](const O& o) { return o.rest_speed; }},
           {"alignment_timeout", [](const O& o) { return o.alignment_timeout; }},
           {"max_lateral_error", [](const O& o) { return o.max_lateral_error; }},
           {"max_longitudinal_error", [](const O& o) { return o.max_longitudinal_error; }},
           {"max_heading_error", [](const O& o) { return o.max_heading_error; }},
           {"max_wheel_error", [](const O& o) { return o.max_wheel_error; }},
           {"clock_slack", [](const O& o) { return o.clock_slack; }},
           {"pose_timeout", [](const O& o) { return o.pose_timeout; }},
           {"wheel_state_timeout", [](const O& o) { return o.wheel_state_timeout; }},
           {"step_timeout", [](const O& o) { return o.step_timeout; }}}};
}

INSTANTIATE_TYPED_TEST_SUITE_P(TrackFile, ParameterLaws, TrackOptions);

TEST(TrackParameters, MakeATracker)
{
  Tracker tracker(Robot(), read_track_file(kTrackFile));
  EXPECT_EQ(tracker.step({}).state, TrackState::idle);
}

/// Without measurements the controller has told the base to stop before that does so by itself and drops its drives.
TEST(TrackParameters, TheControllerStopsBeforeTheBaseDoes)
{
  const TrackOptions track = read_track_file(kTrackFile);
  const double noticed = std::max(track.pose_timeout, track.wheel_state_timeout) + 2.0 / track.controller_frequency;
  EXPECT_LT(noticed, read_simulator_file(FOURWIS_SOURCE_DIR "/config/simulator.yaml").command_timeout);
  EXPECT_LT(noticed, read_bridge_file(FOURWIS_SOURCE_DIR "/config/can_bridge.yaml").command_timeout);
}

TEST(TrackParameters, WhatWouldNotBeRememberedIsRefused)
{
  TrackOptions options;
  options.controller_frequency = 500.0;
  EXPECT_NO_THROW(check(options));
  options.command_latency = 0.2;
  EXPECT_THROW(check(options), std::invalid_argument);
}

TEST(TrackParameters, EverythingTheTableAllowsMakesATracker)
{
  const ParameterMap shipped = read_parameter_file(kTrackFile);
  for (const auto& [key, value] : shipped)
    for (const double bad : {-1e12, 1e12})
    {
      const std::string text = complaint(track_options_from, with(shipped, key, bad));
      double min = 0.0, max = 0.0;
      ASSERT_EQ(std::sscanf(text.c_str() + text.find(" from "), " from %lf to %lf", &min, &max), 2) << text;
      EXPECT_NO_THROW(check(track_options_from(with(shipped, key, bad < 0.0 ? min : max)))) << key;
    }
}

}  // namespace fourwis
