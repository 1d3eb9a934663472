#include <atomic>
#include <cmath>
#include <functional>
#include <future>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <tf2/buffer_core.h>

#include "../support/sentences.h"
#include "inbox.h"
#include "ros/conversions.h"
#include "ros/pose_source.h"

namespace fourwis
{
namespace
{

geometry_msgs::TransformStamped transform(const std::string& parent, const std::string& child, const Pose& pose,
                                          const ros::Time& stamp)
{
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = parent;
  transform.header.stamp = stamp;
  transform.child_frame_id = child;
  transform.transform.translation.x = pose.x;
  transform.transform.translation.y = pose.y;
  transform.transform.rotation = to_message(pose).orientation;
  return transform;
}

geometry_msgs::PoseStamped stamped(const std::string& frame, const Pose& pose)
{
  geometry_msgs::PoseStamped message;
  message.header.frame_id = frame;
  message.pose = to_message(pose);
  return message;
}

geometry_msgs::PoseWithCovarianceStamped initial_pose(const std::string& frame, const Pose& pose)
{
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.frame_id = frame;
  message.pose.pose = to_message(pose);
  return message;
}

void expect_pose(const Pose& pose, const Pose& expected)
{
  EXPECT_NEAR(pose.x, expected.x, 1e-9);
  EXPECT_NEAR(pose.y, expected.y, 1e-9);
  EXPECT_NEAR(wrap_angle(pose.theta - expected.theta), 0.0, 1e-9);
}

class PoseSourceTest : public testing::Test
{
protected:
  PoseSource source(StartFrom start_from)
  {
    GlobalPlannerOptions options;
    options.start_from = start_from;
    options.transform_tolerance = 0.5;
    return PoseSource(options, tf_);
  }

  tf2::BufferCore tf_;
};

TEST_F(PoseSourceTest, a_pose_in_the_global_frame_needs_no_transform)
{
  const PoseSource poses = source(StartFrom::tf);
  expect_pose(poses.to_global(stamped("map", {1, 2, 3}), "goal"), {1, 2, 3});
  expect_pose(poses.to_global(stamped("/map", {1, 2, 3}), "goal"), {1, 2, 3});
}

TEST_F(PoseSourceTest, a_pose_in_another_frame_with_any_stamp_goes_through_the_newest_transform)
{
  const Pose odom{5, -1, M_PI_2};
  tf_.setTransform(transform("map", "odom", {9, 9, 1}, ros::Time(10.0)), "test");
  tf_.setTransform(transform("map", "odom", odom, ros::Time(11.0)), "test");
  geometry_msgs::PoseStamped goal = stamped("odom", {2, 1, 0.25});
  goal.header.stamp = ros::Time(500.0);
  expect_pose(source(StartFrom::tf).to_global(goal, "goal"), compose(odom, {2, 1, 0.25}));
}

TEST_F(PoseSourceTest, a_pose_in_a_frame_that_tf_does_not_know_is_refused_by_name)
{
  const PoseSource poses = source(StartFrom::tf);
  EXPECT_TRUE(says(error_of<ConversionError>([&] { poses.to_global(stamped("moon", {}), "goal"); }),
                   "goal: no transform from 'moon' to 'map'"));
  EXPECT_TRUE(says(error_of<ConversionError>([&] { poses.to_global(stamped("", {}), "goal"); }),
                   "goal: header.frame_id is empty"));
}

TEST_F(PoseSourceTest, a_bad_quaternion_is_refused_before_tf_makes_a_rotation_of_it)
{
  tf_.setTransform(transform("map", "odom", {}, ros::Time(1.0)), "test");
  geometry_msgs::PoseStamped goal = stamped("odom", {});
  goal.pose.orientation.w = 0.0;
  EXPECT_TRUE(says(error_of<ConversionError>([&] { source(StartFrom::tf).to_global(goal, "goal"); }), "norm 0"));
}

TEST_F(PoseSourceTest, a_goal_that_a_transform_tilts_out_of_the_plane_is_refused)
{
  geometry_msgs::TransformStamped wall = transform("map", "camera", {}, ros::Time(1.0));
  wall.transform.rotation.x = wall.transform.rotation.w = std::sqrt(0.5);
  tf_.setTransform(wall, "test");
  EXPECT_TRUE(says(error_of<ConversionError>([&] { source(StartFrom::tf).to_global(stamped("camera", {}), "goal"); }),
                   "tilted"));
}

TEST_F(PoseSourceTest, the_robot_is_where_a_fresh_transform_says)
{
  tf_.setTransform(transform("map", "odom", {1, 0, 0}, ros::Time(10.0)), "test");
  tf_.setTransform(transform("odom", "base_link", {2, 3, 0.5}, ros::Time(10.0)), "test");
  const PoseSource poses = source(StartFrom::tf);
  expect_pose(poses.robot(ros::Time(10.0)), {3, 3, 0.5});
  expect_pose(poses.robot(ros::Time(10.49)), {3, 3, 0.5});
  // Localisation dates its transforms ahead.
  expect_pose(poses.robot(ros::Time(9.0)), {3, 3, 0.5});
}

TEST_F(PoseSourceTest, a_transform_older_than_the_tolerance_is_refused_with_its_age)
{
  tf_.setTransform(transform("map", "base_link", {}, ros::Time(10.0)), "test");
  const std::string text = error_of<ConversionError>([&] { source(StartFrom::tf).robot(ros::Time(12.0)); });
  EXPECT_TRUE(says(text, "is 2 s old, expected at most transform_tolerance = 0.5 s"));
}

TEST_F(PoseSourceTest, a_transform_of_a_wild_stamp_does_no_harm)
{
  tf_.setTransform(transform("map", "base_link", {}, ros::Time(1.0)), "test");
  EXPECT_TRUE(says(error_of<ConversionError>([&] { source(StartFrom::tf).robot(ros::Time(4294967295.0)); }), " s old"));
}

TEST_F(PoseSourceTest, a_static_transform_does_not_age)
{
  tf_.setTransform(transform("map", "base_link", {1, 2, 0}, ros::Time(10.0)), "test", true);
  expect_pose(source(StartFrom::tf).robot(ros::Time(1000.0)), {1, 2, 0});
}

TEST_F(PoseSourceTest, where_the_robot_was_lies_between_two_transforms_even_if_later_ones_came)
{
  const std::atomic<bool> cancelled{false};
  tf_.setTransform(transform("map", "base_link", {1, 0, 0.2}, ros::Time(10.0)), "test");
  tf_.setTransform(transform("map", "base_link", {2, 1, 0.4}, ros::Time(10.1)), "test");
  const PoseSource poses = source(StartFrom::tf);
  const Pose then = poses.robot_at(ros::Time(10.05), cancelled);
  expect_pose(then, {1.5, 0.5, 0.3});
  tf_.setTransform(transform("map", "base_link", {7, 7, 0}, ros::Time(10.2)), "test");
  const Pose again = poses.robot_at(ros::Time(10.05), cancelled);
  EXPECT_EQ(again.x, then.x);
  EXPECT_EQ(again.y, then.y);
  EXPECT_EQ(again.theta, then.theta);
}

TEST_F(PoseSourceTest, where_the_robot_was_is_the_same_to_the_last_bit_whenever_it_is_asked_for)
{
  const std::atomic<bool> cancelled{false};
  const PoseSource poses = source(StartFrom::tf);
  for (int k = 1; k <= 50; ++k)
  {
    const auto hear = [&](double seconds) {
      const double a = k + seconds;
      for (const auto& [parent, child] : {std::pair("map", "odom"), {"odom", "base_link"}})
        tf_.setTransform(transform(parent, child, {0.1 * a, 0.7 * a, 0.3 * a}, ros::Time(a)), "test");
    };
    hear(-0.1);
    hear(0.0);
    std::atomic<bool> asked{false};
    auto early = std::async(std::launch::async, [&] { return asked = true, poses.robot_at(ros::Time(k), cancelled); });
    ASSERT_TRUE(wait_until([&] { return asked.load(); }));
    hear(0.1);
    const Pose first = early.get(), late = poses.robot_at(ros::Time(k), cancelled);
    EXPECT_EQ(first.x, late.x);
    EXPECT_EQ(first.y, late.y);
    EXPECT_EQ(first.theta, late.theta);
  }
}

TEST_F(PoseSourceTest, where_the_robot_is_now_is_waited_for)
{
  const std::atomic<bool> cancelled{false};
  tf_.setTransform(transform("map", "base_link", {1, 0, 0}, ros::Time(10.0)), "test");
  auto pose =
      std::async(std::launch::async, [&] { return source(StartFrom::tf).robot_at(ros::Time(10.2), cancelled); });
  tf_.setTransform(transform("map", "base_link", {1.3, 0, 0}, ros::Time(10.3)), "test");
  expect_pose(pose.get(), {1.2, 0, 0});
}

TEST_F(PoseSourceTest, where_localisation_lags_behind_the_newest_transform_will_do_within_the_tolerance)
{
  const std::atomic<bool> cancelled{false};
  tf_.setTransform(transform("map", "base_link", {1, 0, 0}, ros::Time(10.0)), "test");
  const PoseSource poses = source(StartFrom::tf);
  expect_pose(poses.robot_at(ros::Time(10.4), cancelled), {1, 0, 0});
  EXPECT_TRUE(says(error_of<ConversionError>([&] { poses.robot_at(ros::Time(10.6), cancelled); }), "is 0.6 s old"));
}

TEST_F(PoseSourceTest, a_pose_taken_to_the_global_frame_is_the_same_pose_there_to_the_last_bit)
{
  tf_.setTransform(transform("map", "odom", {0.1, 0.7, 0.3}, ros::Time(10.0)), "test");
  const PoseSource poses = source(StartFrom::tf);
  const geometry_msgs::PoseStamped goal = stamped("odom", {2.1, 1.3, 0.25});
  const Pose direct = poses.to_global(goal, "goal"), again = poses.to_global(poses.in_global(goal, "goal"), "goal");
  EXPECT_EQ(direct.x, again.x);
  EXPECT_EQ(direct.y, again.y);
  EXPECT_EQ(direct.theta, again.theta);
}

TEST_F(PoseSourceTest, without_a_transform_the_start_is_refused_by_name)
{
  EXPECT_TRUE(says(error_of<ConversionError>([&] { source(StartFrom::tf).robot(ros::Time(1.0)); }),
                   "start pose: no transform from 'base_link' to 'map'"));
}

TEST_F(PoseSourceTest, the_last_initial_pose_counts_and_a_bad_one_changes_nothing)
{
  PoseSource poses = source(StartFrom::initial_pose);
  EXPECT_TRUE(says(error_of<ConversionError>([&] { poses.robot(ros::Time(1.0)); }), "'initialpose'"));
  poses.set_initial(initial_pose("map", {1, 2, 3}));
  poses.set_initial(initial_pose("map", {4, 5, 0.5}));
  EXPECT_TRUE(says(error_of<ConversionError>([&] { poses.set_initial(initial_pose("moon", {})); }),
                   "initialpose: no transform"));
  expect_pose(poses.robot(ros::Time(1000.0)), {4, 5, 0.5});
}

}  // namespace
}  // namespace fourwis
