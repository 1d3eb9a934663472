#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "fourwis_navigation/ros/drive_conversions.h"
#include "refusals.h"

namespace fourwis
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

using Commands = fourwis_navigation::WheelCommands;
using States = fourwis_navigation::WheelStates;
using PointMessage = fourwis_navigation::TrajectoryPoint;

Trajectory two_points()
{
  return {{0.0, Mode::lateral, 1.0, 2.0, 3.0, 0.0, 0.1, 0.5, 0.2}, {2.0, Mode::lateral, 1.0, 3.0, 3.1, 1.0, 0.5, 0.0, 0.0}};
}

WheelCommand some_command()
{
  return {Mode::parallel, 4000000000u, {{0.1, 0.2, 0.3, 0.4}, {-1.0, 1.1, 1.2, 1.3}}};
}

template <class Message>
std::string trajectory_refusal(double PointMessage::*field, Message value)
{
  auto message = to_message(two_points(), {});
  message.points[1].*field = value;
  return error_of<ConversionError>([&] { to_trajectory(message); });
}

TEST(DriveConversions, a_trajectory_comes_back_as_it_was)
{
  const Trajectory there = two_points();
  const Trajectory back = to_trajectory(to_message(there, {}));
  ASSERT_EQ(back.size(), there.size());
  for (std::size_t i = 0; i < there.size(); ++i)
  {
    EXPECT_EQ(back[i].mode, there[i].mode);
    for (double TrajectoryPoint::*field :
         {&TrajectoryPoint::t, &TrajectoryPoint::x, &TrajectoryPoint::y, &TrajectoryPoint::theta, &TrajectoryPoint::v,
          &TrajectoryPoint::phi, &TrajectoryPoint::a, &TrajectoryPoint::omega})
      EXPECT_EQ(back[i].*field, there[i].*field);
  }
}

TEST(DriveConversions, a_trajectory_with_a_number_that_is_not_finite_is_refused_naming_point_and_field)
{
  EXPECT_TRUE(says(trajectory_refusal(&PointMessage::t, kNaN), "point 1: t is nan"));
  EXPECT_TRUE(says(trajectory_refusal(&PointMessage::x, kInf), "point 1: x is inf"));
  for (double PointMessage::*field : {&PointMessage::y, &PointMessage::theta, &PointMessage::v, &PointMessage::phi,
                                      &PointMessage::a, &PointMessage::omega})
    EXPECT_TRUE(says(trajectory_refusal(field, kNaN), "expected a finite number"));
}

TEST(DriveConversions, a_mode_that_nobody_drives_is_refused)
{
  for (int mode : {0, 4, 5, 255})
  {
    auto message = to_message(two_points(), {});
    message.points[0].mode = static_cast<std::uint8_t>(mode);
    EXPECT_TRUE(says(error_of<ConversionError>([&] { to_trajectory(message); }), "mode is " + std::to_string(mode)));
  }
}

TEST(DriveConversions, a_command_comes_back_as_it_was)
{
  const WheelCommand there = some_command();
  const Commands message = to_message(there, ros::Time(12, 34));
  EXPECT_EQ(message.header.stamp, ros::Time(12, 34));
  const WheelCommand back = to_command(message);
  EXPECT_EQ(back.mode, there.mode);
  EXPECT_EQ(back.sequence, there.sequence);
  EXPECT_EQ(back.motion.angle, there.motion.angle);
  EXPECT_EQ(back.motion.speed, there.motion.speed);
}

TEST(DriveConversions, a_stop_is_a_stop_whatever_else_the_command_says)
{
  Commands message = to_message(some_command(), {});
  message.mode = PointMessage::NONE;
  message.drive_speed[2] = kNaN;
  const WheelCommand stop = to_command(message);
  EXPECT_EQ(stop.mode, Mode::none);
  EXPECT_EQ(stop.sequence, some_command().sequence);
  EXPECT_EQ(stop.motion.speed, PerWheel{});
}

TEST(DriveConversions, a_command_that_makes_no_sense_is_refused)
{
  Commands angle = to_message(some_command(), {}), speed = angle, mode = angle;
  angle.steering_angle[3] = kNaN;
  speed.drive_speed[0] = -kInf;
  mode.mode = 9;
  EXPECT_TRUE(says(error_of<ConversionError>([&] { to_command(angle); }), "steering_angle is nan"));
  EXPECT_TRUE(says(error_of<ConversionError>([&] { to_command(speed); }), "drive_speed is -inf"));
  EXPECT_TRUE(says(error_of<ConversionError>([&] { to_command(mode); }), "mode is 9"));
}

TEST(DriveConversions, wheel_states_come_back_as_they_were_and_an_unknown_state_is_a_fault)
{
  WheelState there;
  there.stamp = 12.5;
  there.state = BaseState::stopping;
  there.mode = Mode::lateral;
  there.sequence = 7;
  there.motion = some_command().motion;
  there.aligned = true;
  States message = to_message(there, ros::Time(12.5), "rolls out");
  EXPECT_EQ(message.message, "rolls out");
  const WheelState back = to_wheel_state(message);
  EXPECT_EQ(back.stamp, there.stamp);
  EXPECT_EQ(back.state, there.state);
  EXPECT_EQ(back.mode, there.mode);
  EXPECT_EQ(back.sequence, there.sequence);
  EXPECT_EQ(back.motion.angle, there.motion.angle);
  EXPECT_EQ(back.motion.speed, there.motion.speed);
  EXPECT_TRUE(back.aligned);
  message.state = 200;
  EXPECT_EQ(to_wheel_state(message).state, BaseState::fault);
}

}  // namespace
}  // namespace fourwis
