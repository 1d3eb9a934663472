#include <gtest/gtest.h>

#include "../support/sentences.h"
#include "ros/controller_topics.h"
#include "ros/tracking_marker.h"

namespace fourwis
{
namespace
{

using fourwis_navigation::Tracking;

ControlStep some_step()
{
  ControlStep step;
  step.stamp = ros::Time(12.5);
  step.trajectory = ros::Time(11.0);
  step.speed = 0.9;
  step.solve_ms = 0.3;
  step.output.speed = 0.8;
  step.enabled = true;
  step.output.state = TrackState::driving;
  step.output.t = 1.25;
  step.output.lateral_error = 0.0034;
  step.output.longitudinal_error = -0.0056;
  step.output.heading_error = 0.01;
  return step;
}

TEST(ControllerTopics, tracking_says_what_the_step_came_to)
{
  const Tracking tracking = to_message(some_step(), "map");
  EXPECT_EQ(tracking.header.frame_id, "map");
  EXPECT_EQ(tracking.header.stamp, ros::Time(12.5));
  EXPECT_EQ(tracking.trajectory, ros::Time(11.0));
  EXPECT_EQ(tracking.state, Tracking::DRIVING);
  EXPECT_EQ(tracking.message, "");
  EXPECT_EQ(tracking.t, 1.25);
  EXPECT_EQ(tracking.lateral_error, 0.0034);
  EXPECT_EQ(tracking.longitudinal_error, -0.0056);
  EXPECT_EQ(tracking.heading_error, 0.01);
  EXPECT_EQ(tracking.speed, 0.9);
  EXPECT_EQ(tracking.solve_ms, 0.3);
  EXPECT_TRUE(tracking.enabled);
}

TEST(ControllerTopics, a_reason_is_told_with_what_is_behind_it)
{
  ControlStep step = some_step();
  step.problem = "tf: too old";
  EXPECT_EQ(to_message(step, "map").message, "") << "nothing has come of it yet";
  step.output.message = "the robot's pose is not known";
  EXPECT_EQ(to_message(step, "map").message, "the robot's pose is not known: tf: too old");
}

TEST(ControllerTopics, the_states_numbers_are_those_of_the_message)
{
  const std::pair<TrackState, std::uint8_t> pairs[] = {
      {TrackState::idle, Tracking::IDLE},       {TrackState::aligning, Tracking::ALIGNING},
      {TrackState::driving, Tracking::DRIVING}, {TrackState::stopping, Tracking::STOPPING},
      {TrackState::arrived, Tracking::ARRIVED}, {TrackState::failed, Tracking::FAILED}};
  for (const auto& [state, number] : pairs) EXPECT_EQ(static_cast<std::uint8_t>(state), number);
}

TEST(TrackingMarker, follows_the_robot_and_tells_state_and_errors)
{
  Tracking tracking = to_message(some_step(), "map");
  const auto marker = tracking_marker(tracking, "base_link");
  EXPECT_EQ(marker.header.frame_id, "base_link");
  EXPECT_EQ(marker.text, "driving\nlateral 3 mm\nlongitudinal -6 mm");
  tracking.state = Tracking::FAILED;
  tracking.message = "no grip";
  EXPECT_EQ(tracking_marker(tracking, "base_link").text, "gave up\nno grip");
  EXPECT_NE(tracking_marker(tracking, "base_link").color.r, marker.color.r);
}

}  // namespace
}  // namespace fourwis
