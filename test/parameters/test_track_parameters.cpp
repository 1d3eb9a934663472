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
          {{"controller_frequency", [](const O& o) { return o.controller_frequency; }, {5.0, 500.0}},
           {"horizon", [](const O& o) { return o.horizon; }, {0.4, 10.0}},
           {"knots", [](const O& o) { return double(o.knots); }, {2, 200, kWhole}},
           {"lateral_scale", [](const O& o) { return o.lateral_scale; }, {1e-3, 1e3}},
           {"longitudinal_scale", [](const O& o) { return o.longitudinal_scale; }, {1e-3, 1e3}},
           {"heading_scale", [](const O& o) { return o.heading_scale; }, {1e-3, 1e3}},
           {"speed_scale", [](const O& o) { return o.speed_scale; }, {1e-3, 1e3}},
           {"steering_scale", [](const O& o) { return o.steering_scale; }, {1e-3, 1e3}},
           {"acceleration_scale", [](const O& o) { return o.acceleration_scale; }, {1e-3, 1e3}},
           {"steering_rate_scale", [](const O& o) { return o.steering_rate_scale; }, {1e-3, 1e3}},
           {"command_latency", [](const O& o) { return o.command_latency; }, {0.0, 0.5}},
           {"drive_lag", [](const O& o) { return o.drive_lag; }, {0.0, 0.5}},
           {"steering_lag", [](const O& o) { return o.steering_lag; }, {0.0, 0.5}},
           {"xy_start_tolerance", [](const O& o) { return o.xy_start_tolerance; }, {1e-3, 1.0}},
           {"yaw_start_tolerance", [](const O& o) { return o.yaw_start_tolerance; }, {1e-3, 3.15}},
           {"xy_goal_tolerance", [](const O& o) { return o.xy_goal_tolerance; }, {1e-3, 1.0}},
           {"yaw_goal_tolerance", [](const O& o) { return o.yaw_goal_tolerance; }, {1e-3, 3.15}},
           {"xy_switch_tolerance", [](const O& o) { return o.xy_switch_tolerance; }, {1e-3, 1.0}},
           {"yaw_switch_tolerance", [](const O& o) { return o.yaw_switch_tolerance; }, {1e-3, 3.15}},
           {"max_xy_correction", [](const O& o) { return o.max_xy_correction; }, {1e-3, 1.0}},
           {"max_yaw_correction", [](const O& o) { return o.max_yaw_correction; }, {1e-3, 3.15}},
           {"correction_speed", [](const O& o) { return o.correction_speed; }, {0.01, 1.0}},
           {"correction_timeout", [](const O& o) { return o.correction_timeout; }, {0.0, 600.0}},
           {"settle_time", [](const O& o) { return o.settle_time; }, {0.0, 60.0}},
           {"rest_speed", [](const O& o) { return o.rest_speed; }, {1e-4, 1.0}},
           {"alignment_timeout", [](const O& o) { return o.alignment_timeout; }, {0.0, 600.0}},
           {"max_lateral_error", [](const O& o) { return o.max_lateral_error; }, {1e-3, 3.0}},
           {"max_longitudinal_error", [](const O& o) { return o.max_longitudinal_error; }, {1e-3, 3.0}},
           {"max_heading_error", [](const O& o) { return o.max_heading_error; }, {1e-3, 3.15}},
           {"max_wheel_error", [](const O& o) { return o.max_wheel_error; }, {1e-2, 3.15}},
           {"clock_slack", [](const O& o) { return o.clock_slack; }, {1e-3, 3.0}},
           {"pose_timeout", [](const O& o) { return o.pose_timeout; }, {0.01, 2.0}},
           {"wheel_state_timeout", [](const O& o) { return o.wheel_state_timeout; }, {0.01, 2.0}},
           {"step_timeout", [](const O& o) { return o.step_timeout; }, {0.01, 60.0}},
           {"permit_timeout", [](const O& o) { return o.permit_timeout; }, {0.1, 60.0}}}};
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

TEST(TrackParameters, WhatWouldNotBeRememberedIsRejected)
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
  for (const auto& [key, get, limits] : subject_of<TrackOptions>().bindings)
    for (const double limit : {limits.least, limits.greatest})
      EXPECT_NO_THROW(check(track_options_from(with(shipped, key, limit)))) << key;
}

}  // namespace fourwis
