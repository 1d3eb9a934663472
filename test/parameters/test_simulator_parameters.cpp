#include <string>

#include <gtest/gtest.h>

#include "fourwis_navigation/sim/base_simulator.h"
#include "parameter_laws.h"

namespace fourwis
{

const std::string kSimulatorFile = FOURWIS_SOURCE_DIR "/config/simulator.yaml";

template <>
Subject<SimulatorOptions> subject_of()
{
  using O = SimulatorOptions;
  return {kSimulatorFile,
          simulator_options_from,
          {{"seed", [](const O& o) { return double(o.seed); }},
           {"time_step", [](const O& o) { return o.time_step; }},
           {"command_latency", [](const O& o) { return o.command_latency; }},
           {"command_timeout", [](const O& o) { return o.command_timeout; }},
           {"stop_deceleration", [](const O& o) { return o.stop_deceleration; }},
           {"steering_lag", [](const O& o) { return o.actuators.steering_lag; }},
           {"drive_lag", [](const O& o) { return o.actuators.drive_lag; }},
           {"drive_acceleration", [](const O& o) { return o.actuators.drive_acceleration; }},
           {"drive_slip", [](const O& o) { return o.slip.drive_slip; }},
           {"lateral_slip", [](const O& o) { return o.slip.lateral_slip; }},
           {"angle_resolution", [](const O& o) { return o.encoders.angle_resolution; }},
           {"angle_noise", [](const O& o) { return o.encoders.angle_noise; }},
           {"speed_resolution", [](const O& o) { return o.encoders.speed_resolution; }},
           {"speed_noise", [](const O& o) { return o.encoders.speed_noise; }},
           {"largest_jump", [](const O& o) { return o.interlock.largest_jump; }},
           {"standstill_speed", [](const O& o) { return o.interlock.standstill_speed; }},
           {"standstill_time", [](const O& o) { return o.interlock.standstill_time; }},
           {"aligned_angle", [](const O& o) { return o.interlock.aligned_angle; }},
           {"aligned_time", [](const O& o) { return o.interlock.aligned_time; }},
           {"alignment_timeout", [](const O& o) { return o.interlock.alignment_timeout; }}}};
}

INSTANTIATE_TYPED_TEST_SUITE_P(SimulatorFile, ParameterLaws, SimulatorOptions);

TEST(SimulatorParameters, MakeASimulator)
{
  BaseSimulator base(Robot(), read_simulator_file(kSimulatorFile));
  base.step(0.1);
  EXPECT_NEAR(base.time(), 0.1, 1e-12);
}

}  // namespace fourwis
