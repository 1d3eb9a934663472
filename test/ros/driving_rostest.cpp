#include <limits>
#include <set>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Path.h>

#include "drive_fixture.h"
#include "fourwis_navigation/model/fingerprint.h"

namespace fourwis
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The controller is told to drive, and to stop.
class Driving : public DriveFixture
{
protected:
  void SetUp() override
  {
    DriveFixture::SetUp();
    connect();
  }

  /// The modes that the wheels have moved in.
  std::set<int> driven_modes() const
  {
    std::set<int> modes;
    for (const auto& state : wheel_states_.messages())
      if (std::abs(state->drive_speed[0]) > 0.1) modes.insert(state->mode);
    return modes;
  }

  void expect_refused(const ModeTrajectory& trajectory, const std::string& reason)
  {
    trajectory_.publish(trajectory);
    const auto says_so = [&](const Tracking& t) {
      return t.state == Tracking::REFUSED && t.trajectory == trajectory.header.stamp &&
             t.message.find(reason) != std::string::npos;
    };
    EXPECT_TRUE(wait_for_tracking(says_so)) << reason;
  }
};

struct Way
{
  std::string name;
  ModeSet modes;
  Pose goal;
};

class EveryMode : public Driving, public testing::WithParamInterface<Way>
{};

TEST_P(EveryMode, reaches_the_goal)
{
  const Way& way = GetParam();
  const Trajectory trajectory = plan(way.goal, way.modes);
  ASSERT_FALSE(trajectory.empty());
  ASSERT_TRUE(wait_for_state(Tracking::ARRIVED, send(trajectory)));
  expect_at(way.goal);
  std::set<int> planned;
  for (const TrajectoryPoint& point : trajectory) planned.insert(static_cast<int>(point.mode));
  EXPECT_EQ(driven_modes(), planned);
}

INSTANTIATE_TEST_SUITE_P(Ways, EveryMode,
                         testing::Values(Way{"ackermann", {Mode::ackermann}, {13, 11, 0.6}},
                                         Way{"lateral", {Mode::lateral}, {10.5, 13, 0.3}},
                                         Way{"parallel", {Mode::parallel}, {12, 12, 0}},
                                         Way{"any", {}, {12, 13, M_PI / 2}}),
                         [](const auto& given) { return given.param.name; });

TEST_F(Driving, an_empty_trajectory_stops_it_and_the_wheels_keep_their_angles)
{
  wait_for_motion(send(plan({16, 12, 0.5}, {Mode::ackermann})));
  const auto before = wheel_states_.messages().back();
  const ros::Time end = stop();
  ASSERT_TRUE(wait_for_state(Tracking::IDLE, end));
  wait_for_rest();
  const Pose there = truth();
  EXPECT_LT(distance(there, kMiddle), 5.0);
  const auto angles = wheel_states_.messages().back()->steering_angle;
  pass(0.5);
  EXPECT_EQ(wheel_states_.messages().back()->steering_angle, angles);
  EXPECT_LT(distance(truth(), there), 1e-4);
}

TEST_F(Driving, the_commands_are_told_as_a_twist_and_the_prediction_is_a_path)
{
  Inbox<geometry_msgs::Twist> twists("cmd_vel");
  Inbox<nav_msgs::Path> paths("mpc_controller/predicted_path");
  ASSERT_TRUE(wait_until([&] { return twists.connected() && paths.connected(); }));
  send(plan({10, 14, 0}, {Mode::lateral}));
  const auto twist = twists.wait_for([](const geometry_msgs::Twist& t) { return t.linear.y > 0.5; });
  ASSERT_TRUE(twist);
  EXPECT_EQ(twist->linear.x, 0.0);
  const auto path = paths.wait_for([](const nav_msgs::Path& p) { return p.poses.size() > 2; });
  ASSERT_TRUE(path);
  EXPECT_EQ(path->header.frame_id, "map");
  EXPECT_GT(path->poses.back().pose.position.y, path->poses.front().pose.position.y);
}

TEST_F(Driving, diagnostics_tell_of_it)
{
  Inbox<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  send(plan({14, 10, 0}, {Mode::ackermann}));
  const auto array = diagnostics.wait_for([](const diagnostic_msgs::DiagnosticArray& a) {
    return a.status.size() == 1 && a.status[0].message == "driving";
  });
  ASSERT_TRUE(array);
  EXPECT_EQ(array->status[0].name, "mpc_controller: tracking");
  const diagnostic_msgs::KeyValue& robot = array->status[0].values.front();
  EXPECT_EQ(robot.key, "fingerprint of the robot");
  EXPECT_EQ(robot.value, fingerprint(Robot()));
  const diagnostic_msgs::KeyValue& slowest = array->status[0].values.back();
  EXPECT_EQ(slowest.key, "slowest step [ms]");
  EXPECT_GT(std::stod(slowest.value), 0.0);
}

TEST_F(Driving, a_trajectory_that_makes_no_sense_is_refused_and_the_drive_goes_on)
{
  const Pose goal{16, 10, 0};
  const Trajectory trajectory = plan(goal, {Mode::ackermann});
  const ros::Time drive = send(trajectory);
  wait_for_motion(drive);
  std_msgs::Header header;
  header.frame_id = "map";
  const auto message = [&](const std::string& frame, double seconds) {
    header.frame_id = frame;
    header.stamp = ros::Time::now() + ros::Duration(seconds);
    return to_message(Robot(), trajectory, header);
  };

  expect_refused(message("odom", 0.0), "header.frame_id is 'odom', expected global_frame = 'map'");
  expect_refused(message("", 0.0), "header.frame_id is ''");
  expect_refused(message("map", 3600.0), "s after the newest odometry");
  expect_refused(message("map", -900.0), "before the controller started");
  ModeTrajectory bad = message("map", 0.0);
  bad.points[1].theta = kNaN;
  expect_refused(bad, "point 1: holds something that is no finite number");
  bad = message("map", 0.0);
  bad.fingerprint = "0123456789abcdef";
  expect_refused(bad, "was planned for another robot: fingerprint is '0123456789abcdef'");
  bad = message("map", 0.0);
  bad.points[0].mode = 77;
  expect_refused(bad, "point 0: its mode is not known (77)");

  ASSERT_TRUE(wait_for_state(Tracking::ARRIVED, drive));
  expect_at(goal);
}

TEST_F(Driving, waits_for_the_time_at_which_a_trajectory_begins)
{
  const Pose goal{11, 10, 0};
  std_msgs::Header header;
  header.frame_id = "map";
  header.stamp = ros::Time::now() + ros::Duration(1.0);
  trajectory_.publish(to_message(Robot(), plan(goal), header));
  ASSERT_TRUE(wait_for_state(Tracking::ARRIVED, header.stamp));
  for (const auto& tracking : tracking_.messages())
    EXPECT_EQ(tracking->trajectory == header.stamp, tracking->header.stamp >= header.stamp);
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_driving");
}
