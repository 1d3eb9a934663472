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
          {{"seed", [](const O& o) { return double(o.seed); }, {0, 1e9, kWhole}},
           {"time_step", [](const O& o) { return o.time_step; }, {1e-4, 0.01}},
           {"command_latency", [](const O& o) { return o.command_latency; }, {0.0, 2.0}},
           {"command_timeout", [](const O& o) { return o.command_timeout; }, {0.01, 10.0}},
           {"stop_deceleration", [](const O& o) { return o.stop_deceleration; }, {0.1, 100.0}},
           {"steering_lag", [](const O& o) { return o.actuators.steering_lag; }, {0.0, 1.0}},
           {"drive_lag", [](const O& o) { return o.actuators.drive_lag; }, {0.0, 1.0}},
           {"drive_acceleration", [](const O& o) { return o.actuators.drive_acceleration; }, {0.01, 1000.0}},
           {"drive_slip", [](const O& o) { return o.slip.drive_slip; }, {-0.9, 0.9}},
           {"lateral_slip", [](const O& o) { return o.slip.lateral_slip; }, {0.0, 0.1}},
           {"angle_resolution", [](const O& o) { return o.encoders.angle_resolution; }, {0.0, 0.1}},
           {"angle_noise", [](const O& o) { return o.encoders.angle_noise; }, {0.0, 0.1}},
           {"speed_resolution", [](const O& o) { return o.encoders.speed_resolution; }, {0.0, 0.1}},
           {"speed_noise", [](const O& o) { return o.encoders.speed_noise; }, {0.0, 0.1}},
           {"largest_jump", [](const O& o) { return o.interlock.largest_jump; }, {0.01, 10.0}},
           {"standstill_speed", [](const O& o) { return o.interlock.standstill_speed; }, {1e-4, 1.0}},
           {"standstill_time", [](const O& o) { return o.interlock.standstill_time; }, {0.0, 10.0}},
           {"aligned_angle", [](const O& o) { return o.interlock.aligned_angle; }, {1e-4, 0.5}},
           {"aligned_time", [](const O& o) { return o.interlock.aligned_time; }, {0.0, 10.0}},
           {"alignment_timeout", [](const O& o) { return o.interlock.alignment_timeout; }, {0.01, 3600.0}}}};
}

INSTANTIATE_TYPED_TEST_SUITE_P(SimulatorFile, ParameterLaws, SimulatorOptions);

TEST(SimulatorParameters, MakeASimulator)
{
  BaseSimulator base(Robot(), read_simulator_file(kSimulatorFile));
  base.step(0.1);
  EXPECT_NEAR(base.time(), 0.1, 1e-12);
}

}  // namespace fourwis
