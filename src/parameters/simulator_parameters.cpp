#include "parameter_table.h"

namespace fourwis
{
namespace
{

template <class Value>
auto simulator(Value SimulatorOptions::*member)
{
  return [member](SimulatorOptions& options) -> Slot { return &(options.*member); };
}

auto actuators(double ActuatorOptions::*member)
{
  return [member](SimulatorOptions& options) -> Slot { return &(options.actuators.*member); };
}

auto slip(double SlipOptions::*member)
{
  return [member](SimulatorOptions& options) -> Slot { return &(options.slip.*member); };
}

auto encoders(double EncoderOptions::*member)
{
  return [member](SimulatorOptions& options) -> Slot { return &(options.encoders.*member); };
}

auto interlock(double InterlockOptions::*member)
{
  return [member](SimulatorOptions& options) -> Slot { return &(options.interlock.*member); };
}

const ParameterTable<SimulatorOptions>& simulator_table()
{
  static const ParameterTable<SimulatorOptions> table = {
      {"seed", simulator(&SimulatorOptions::seed), 0, 1e9},
      {"time_step", simulator(&SimulatorOptions::time_step), 1e-4, 0.01, "s"},

      {"command_latency", simulator(&SimulatorOptions::command_latency), 0.0, 2.0, "s"},
      {"command_timeout", simulator(&SimulatorOptions::command_timeout), 0.01, 10.0, "s"},
      {"stop_deceleration", simulator(&SimulatorOptions::stop_deceleration), 0.1, 100.0, "m/s^2"},

      {"steering_lag", actuators(&ActuatorOptions::steering_lag), 0.0, 1.0, "s"},
      {"drive_lag", actuators(&ActuatorOptions::drive_lag), 0.0, 1.0, "s"},
      {"drive_acceleration", actuators(&ActuatorOptions::drive_acceleration), 0.01, 1000.0, "m/s^2"},

      {"drive_slip", slip(&SlipOptions::drive_slip), -0.9, 0.9},
      {"lateral_slip", slip(&SlipOptions::lateral_slip), 0.0, 0.1, "rad s^2/m"},

      {"angle_resolution", encoders(&EncoderOptions::angle_resolution), 0.0, 0.1, "rad"},
      {"angle_noise", encoders(&EncoderOptions::angle_noise), 0.0, 0.1, "rad"},
      {"speed_resolution", encoders(&EncoderOptions::speed_resolution), 0.0, 0.1, "m/s"},
      {"speed_noise", encoders(&EncoderOptions::speed_noise), 0.0, 0.1, "m/s"},

      {"largest_jump", interlock(&InterlockOptions::largest_jump), 0.01, 10.0, "rad"},
      {"standstill_speed", interlock(&InterlockOptions::standstill_speed), 1e-4, 1.0, "m/s"},
      {"standstill_time", interlock(&InterlockOptions::standstill_time), 0.0, 10.0, "s"},
      {"aligned_angle", interlock(&InterlockOptions::aligned_angle), 1e-4, 0.5, "rad"},
      {"aligned_time", interlock(&InterlockOptions::aligned_time), 0.0, 10.0, "s"},
      {"alignment_timeout", interlock(&InterlockOptions::alignment_timeout), 0.01, 3600.0, "s"},
  };
  return table;
}

}  // namespace

SimulatorOptions simulator_options_from(const ParameterMap& parameters)
{
  return options_from(simulator_table(), parameters);
}

}  // namespace fourwis
