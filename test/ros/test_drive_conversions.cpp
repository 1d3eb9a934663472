#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "ros/drive_conversions.h"

namespace fourwis
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Commands = fourwis_navigation::WheelCommands;
using States = fourwis_navigation::WheelStates;

Trajectory two_points()
{
  return {{0.0, Mode::lateral, 1.0, 2.0, 3.0, 0.0, 0.1, 0.5, 0.2},
          {2.0, Mode::lateral, 1.0, 3.0, 3.1, 1.0, 0.5, 0.0, 0.0}};
}

WheelCommand some_command()
{
  return {Mode::parallel, 4000000000u, {{0.1, 0.2, 0.3, 0.4}, {-1.0, 1.1, 1.2, 1.3}}};
}

TEST(DriveConversions, a_trajectory_comes_back_as_it_was)
{
  const Trajectory there = two_points();
  const Trajectory back = to_trajectory(to_message(Robot(), there, {}));
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

TEST(DriveConversions, what_makes_no_sense_arrives_as_it_is)
{
  Commands command = to_message(some_command(), {});
  command.drive_speed[0] = kNaN;
  command.mode = 200;
  EXPECT_TRUE(std::isnan(to_command(command).motion.speed[0]));
  EXPECT_EQ(static_cast<int>(to_command(command).mode), 200);
  auto trajectory = to_message(Robot(), two_points(), {});
  trajectory.points[1].theta = kNaN;
  EXPECT_TRUE(std::isnan(to_trajectory(trajectory)[1].theta));
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
