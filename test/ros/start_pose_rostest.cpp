#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include "planner_fixture.h"

namespace fourwis
{
namespace
{

rosgraph_msgs::Clock clock_message(double seconds)
{
  rosgraph_msgs::Clock clock;
  clock.clock = ros::Time(seconds);
  return clock;
}

ros::Publisher clock_publisher;

/// The planner takes its start from tf, on a clock that only the tests move.
class StartPose : public PlannerFixture
{
protected:
  void SetUp() override
  {
    PlannerFixture::SetUp();
    ASSERT_TRUE(wait_until([this] { return tf_.getNumSubscribers() > 0 && static_tf_.getNumSubscribers() > 0; }));
    // Each test has a later hour of its own, in which older transforms are stale.
    hour_ += 3600.0;
    set_time(0.0);
    set_map(walled_map(10.0, 0.1, hour_));
    statuses_.clear();
  }

  /// Returns when the planner's clock shows it.
  void set_time(double seconds)
  {
    const rosgraph_msgs::Clock clock = clock_message(hour_ + seconds);
    clock_publisher.publish(clock);
    ASSERT_TRUE(wait_until([&] { return plan(stamped({}), stamped({})).trajectory.header.stamp == clock.clock; }));
  }

  tf2_msgs::TFMessage transform(const std::string& parent, const std::string& child, const Pose& pose, double seconds)
  {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = parent;
    transform.header.stamp = ros::Time(hour_ + seconds);
    transform.child_frame_id = child;
    transform.transform.translation.x = pose.x;
    transform.transform.translation.y = pose.y;
    transform.transform.rotation = to_message(pose).orientation;
    tf2_msgs::TFMessage message;
    message.transforms.push_back(transform);
    return message;
  }

  /// Where the planner says that the robot is, or why it does not know.
  PlanTrajectory::Response plan_from_robot() { return plan(stamped({}, ""), stamped({8, 8, 0})); }

  void expect_refused(const std::string& part)
  {
    const PlanTrajectory::Response answer = plan_from_robot();
    EXPECT_EQ(answer.status, "invalid_input");
    EXPECT_NE(answer.message.find(part), std::string::npos) << "'" << answer.message << "' lacks '" << part << "'";
  }

  static double hour_;
  ros::Publisher tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
  ros::Publisher static_tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 100);
};

double StartPose::hour_ = 0.0;

TEST_F(StartPose, without_a_transform_goals_are_refused_by_name)
{
  expect_refused("no transform from 'base_link' to 'map'");
  send_goal(Pose{8, 8, 0});
  const auto refused = wait_for_status("invalid_input", {8, 8, 0});
  ASSERT_TRUE(refused);
  EXPECT_NE(refused->message.find("start pose"), std::string::npos) << refused->message;
}

TEST_F(StartPose, a_plan_starts_where_tf_has_the_robot_now)
{
  tf_.publish(transform("map", "base_link", {2, 3, 0.5}, 0.0));
  ASSERT_TRUE(wait_until([this] { return starts_at({2, 3, 0.5}); }));
  tf_.publish(transform("map", "base_link", {4, 5, 0.5}, 0.1));
  ASSERT_TRUE(wait_until([this] { return starts_at({4, 5, 0.5}); }));
}

TEST_F(StartPose, a_transform_older_than_the_tolerance_is_refused_with_its_age)
{
  tf_.publish(transform("map", "base_link", {2, 3, 0}, 0.0));
  ASSERT_TRUE(wait_until([this] { return starts_at({2, 3, 0}); }));
  set_time(0.4);
  EXPECT_TRUE(starts_at({2, 3, 0}));
  set_time(2.0);
  expect_refused("is 2 s old, expected at most transform_tolerance = 0.5 s");
}

TEST_F(StartPose, a_goal_in_another_frame_is_transformed)
{
  tf_.publish(transform("map", "base_link", {2, 3, 0}, 0.0));
  static_tf_.publish(transform("map", "kitchen", {5, 1, M_PI_2}, 0.0));
  ASSERT_TRUE(wait_until([this] { return starts_at({2, 3, 0}); }));
  // 4 m along the kitchen's x axis, which is the map's y axis.
  ASSERT_TRUE(wait_until([this] { return plan(stamped({}, ""), stamped({4, 0, 0}, "kitchen")).success; }));
  send_goal(stamped({4, 0, 0}, "kitchen"));
  ASSERT_TRUE(wait_for_status("succeeded", {4, 0, 0}));
  const auto trajectory = trajectories_.wait_for(
      [this](const ModeTrajectory& t) { return t.header.stamp >= ros::Time(hour_) && !t.points.empty(); });
  ASSERT_TRUE(trajectory);
  EXPECT_EQ(trajectory->header.frame_id, "map");
  EXPECT_NEAR(trajectory->points.back().x, 5.0, 1e-3);
  EXPECT_NEAR(trajectory->points.back().y, 5.0, 1e-3);
  EXPECT_NEAR(wrap_angle(trajectory->points.back().theta - M_PI_2), 0.0, 1e-3);
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  ros::init(argc, argv, "test_start_pose");
  ros::NodeHandle node;
  // Before the first test: action clients do not come into being before time does.
  fourwis::clock_publisher = node.advertise<rosgraph_msgs::Clock>("/clock", 10, true);
  fourwis::clock_publisher.publish(fourwis::clock_message(1.0));
  const int result = fourwis::run_rostest(argc, argv, "test_start_pose");
  fourwis::clock_publisher.shutdown();
  return result;
}
