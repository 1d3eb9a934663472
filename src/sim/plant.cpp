#include "fourwis_navigation/sim/plant.h"

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{

Plant::Plant(const Robot& robot, const ActuatorOptions& actuators, const SlipOptions& slip)
  : wheels_(kWheels,
            Wheel{Actuator({checked(robot).wheel_max_angle, robot.wheel_max_rate, checked(actuators).steering_lag}),
                  Actuator({robot.wheel_max_speed, actuators.drive_acceleration, actuators.drive_lag})}),
    body_(robot, slip)
{}

void Plant::place(const Pose& pose)
{
  body_.place(pose);
  for (Wheel& wheel : wheels_)
  {
    wheel.drive.set_target(0.0);
    wheel.drive.set_value(0.0);
  }
}

void Plant::step(double duration)
{
  DrivenWheels driven{};
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    Wheel& wheel = wheels_[i];
    driven[i] = wheel.driven;
    if (wheel.steered) wheel.steering.step(duration);
    if (wheel.driven) wheel.drive.step(duration);
  }
  body_.step(duration, wheels(), driven);
  for (int i = 0; i < kWheels; ++i)
    if (!at(i).driven) at(i).drive.set_value(body_.rolling_speed(i, angle(i)));
}

WheelMotion Plant::wheels() const
{
  WheelMotion motion;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    motion.angle[i] = wheels_[i].steering.value();
    motion.speed[i] = wheels_[i].drive.value();
  }
  return motion;
}

}  // namespace fourwis
