#include <gtest/gtest.h>

#include "ros/drive_monitor.h"

namespace fourwis
{
namespace
{

using fourwis_navigation::Tracking;

constexpr double kControllerPatience = 5.0;
const ros::Time kBegin(100.2), kSent(100.0);

class DriveMonitorTest : public testing::Test
{
protected:
  /// The controller says at `seconds` that it is in `state` with the trajectory of this stamp.
  void hear(double seconds, std::uint8_t state, const ros::Time& trajectory, const std::string& message = "",
            bool enabled = true)
  {
    Tracking tracking;
    tracking.header.stamp = now_ = ros::Time(seconds);
    tracking.state = state;
    tracking.trajectory = trajectory;
    tracking.message = message;
    tracking.enabled = enabled;
    tracking.t = seconds - kBegin.toSec();
    monitor_.reported(tracking, now_);
  }

  DrivePhase phase() const { return monitor_.report(now_).phase; }
  bool rests() const { return monitor_.at_rest_since(now_).has_value(); }

  void begin_to_drive()
  {
    hear(99.9, Tracking::IDLE, {});
    monitor_.sending_trajectory(kBegin, kSent);
    hear(100.3, Tracking::DRIVING, kBegin);
    ASSERT_EQ(phase(), DrivePhase::driving);
  }

  DriveMonitor monitor_{kControllerPatience};
  ros::Time now_{99.0};
};

TEST_F(DriveMonitorTest, the_robot_is_not_known_to_rest_before_the_controller_says_so)
{
  EXPECT_FALSE(rests());
  hear(99.5, Tracking::DRIVING, ros::Time(80.0));  // what another planner sent
  EXPECT_FALSE(rests());
  hear(99.6, Tracking::IDLE, {});
  hear(99.7, Tracking::IDLE, {});
  EXPECT_EQ(monitor_.at_rest_since(now_), ros::Time(99.6));
}

TEST_F(DriveMonitorTest, a_controller_is_not_silent_while_the_planner_sleeps)
{
  begin_to_drive();
  const double awake = 100.3 + 3.0 * kControllerPatience;
  monitor_.slept_until(ros::Time(awake));
  now_ = ros::Time(awake + 0.9 * kControllerPatience);
  EXPECT_EQ(phase(), DrivePhase::driving);
  now_ = ros::Time(awake + 1.1 * kControllerPatience);
  EXPECT_EQ(phase(), DrivePhase::lost);
}

TEST_F(DriveMonitorTest, a_drive_goes_from_pending_by_driving_to_arrived)
{
  hear(99.9, Tracking::ARRIVED, ros::Time(80.0));
  monitor_.sending_trajectory(kBegin, kSent);
  EXPECT_EQ(phase(), DrivePhase::pending);
  hear(100.1, Tracking::ARRIVED, ros::Time(80.0));  // still about the one before
  EXPECT_EQ(phase(), DrivePhase::pending);
  EXPECT_FALSE(rests()) << "it will begin at any moment";
  hear(100.2, Tracking::ALIGNING, kBegin);
  EXPECT_EQ(phase(), DrivePhase::driving);
  hear(101.2, Tracking::DRIVING, kBegin);
  EXPECT_NEAR(monitor_.report(now_).t, 1.0, 1e-9);
  EXPECT_FALSE(rests());
  hear(110.0, Tracking::ARRIVED, kBegin);
  hear(110.1, Tracking::ARRIVED, kBegin);
  EXPECT_EQ(phase(), DrivePhase::arrived);
  EXPECT_EQ(monitor_.report(now_).since, ros::Time(110.0));
  EXPECT_EQ(monitor_.at_rest_since(now_), ros::Time(110.0));
}

TEST_F(DriveMonitorTest, a_failure_has_the_controllers_reason_and_stays_when_the_controller_forgets_it)
{
  begin_to_drive();
  hear(101.0, Tracking::STOPPING, kBegin, "off the path");
  EXPECT_EQ(phase(), DrivePhase::driving);
  hear(101.5, Tracking::FAILED, kBegin, "off the path by 0.3 m");
  hear(101.6, Tracking::IDLE, {});
  EXPECT_EQ(phase(), DrivePhase::failed);
  EXPECT_EQ(monitor_.report(now_).message, "off the path by 0.3 m");
}

TEST_F(DriveMonitorTest, a_disabled_base_counts_for_earlier_goals_also_after_new_trajectories)
{
  begin_to_drive();
  EXPECT_FALSE(monitor_.disabled_since(ros::Time(0.1))) << "has always been enabled";
  hear(101.0, Tracking::STOPPING, kBegin, "the base stops by itself", false);
  EXPECT_TRUE(monitor_.disabled_since(kSent));
  EXPECT_FALSE(monitor_.enabled_again_since(kSent)) << "is still disabled";
  monitor_.sending_stop(ros::Time(101.2), now_);
  hear(101.5, Tracking::IDLE, ros::Time(101.2));
  monitor_.sending_trajectory(ros::Time(102.0), now_);
  hear(102.0, Tracking::DRIVING, ros::Time(102.0));
  EXPECT_TRUE(monitor_.disabled_since(kSent));
  EXPECT_TRUE(monitor_.enabled_again_since(kSent));
  EXPECT_FALSE(monitor_.disabled_since(ros::Time(101.0))) << "asked for since";
  EXPECT_FALSE(monitor_.enabled_again_since(ros::Time(101.0)));
}

TEST_F(DriveMonitorTest, a_refusal_says_nothing_about_the_base)
{
  begin_to_drive();
  hear(101.0, Tracking::REFUSED, ros::Time(50.0), "header.frame_id is 'odom'", false);
  EXPECT_FALSE(monitor_.disabled_since(kSent));
}

TEST_F(DriveMonitorTest, when_the_clock_goes_back_so_does_when_the_base_was_disabled)
{
  hear(100.0, Tracking::IDLE, {}, "", false);
  hear(80.0, Tracking::IDLE, {});
  EXPECT_FALSE(monitor_.disabled_since(ros::Time(80.0)));
}

TEST_F(DriveMonitorTest, a_refusal_to_another_node_changes_nothing)
{
  begin_to_drive();
  hear(101.0, Tracking::REFUSED, ros::Time(50.0), "header.frame_id is 'odom'");
  EXPECT_EQ(phase(), DrivePhase::driving);
  EXPECT_FALSE(rests());
  hear(110.0, Tracking::ARRIVED, kBegin);
  hear(110.1, Tracking::REFUSED, ros::Time(50.0), "header.frame_id is 'odom'");
  EXPECT_EQ(phase(), DrivePhase::arrived);
  EXPECT_EQ(monitor_.at_rest_since(now_), ros::Time(110.0));
}

TEST_F(DriveMonitorTest, a_trajectory_that_is_refused_is_lost_whether_it_had_begun_or_not)
{
  begin_to_drive();
  hear(101.0, Tracking::REFUSED, kBegin,
       "was planned before the controller started");  // a new one, which got it latched
  EXPECT_EQ(phase(), DrivePhase::lost);
  EXPECT_FALSE(rests());
  monitor_.sending_trajectory(ros::Time(103.0), now_);
  hear(102.0, Tracking::REFUSED, ros::Time(103.0), "came before odometry");
  EXPECT_EQ(phase(), DrivePhase::lost);
  EXPECT_EQ(monitor_.report(now_).message, "came before odometry");
}

TEST_F(DriveMonitorTest, where_the_robot_was_on_the_trajectory_is_known_while_the_wheels_align)
{
  begin_to_drive();
  hear(105.2, Tracking::DRIVING, kBegin);
  Tracking aligning;
  aligning.header.stamp = now_;
  aligning.state = Tracking::ALIGNING;
  aligning.trajectory = kBegin;
  monitor_.reported(aligning, now_);
  EXPECT_NEAR(monitor_.report(now_).t, 5.0, 1e-9);
}

TEST_F(DriveMonitorTest, when_the_clock_goes_back_so_does_the_time_of_rest)
{
  hear(100.0, Tracking::IDLE, {});
  hear(80.0, Tracking::IDLE, {});
  EXPECT_EQ(monitor_.at_rest_since(now_), ros::Time(80.0));
  EXPECT_FALSE(monitor_.at_rest_since(ros::Time(85.1))) << "heard of long ago";
}

TEST_F(DriveMonitorTest, a_controller_that_forgets_the_trajectory_has_lost_it)
{
  begin_to_drive();
  hear(101.0, Tracking::IDLE, {});  // restarted
  EXPECT_EQ(phase(), DrivePhase::lost);
  EXPECT_NE(monitor_.report(now_).message.find("dropped"), std::string::npos);
  EXPECT_TRUE(rests());
  hear(101.1, Tracking::DRIVING, ros::Time(50.0));
  EXPECT_FALSE(rests());
}

TEST_F(DriveMonitorTest, a_controller_that_does_not_begin_in_time_has_lost_the_trajectory)
{
  monitor_.sending_trajectory(kBegin, kSent);
  hear(105.1, Tracking::IDLE, {});
  EXPECT_EQ(phase(), DrivePhase::pending);
  hear(105.3, Tracking::IDLE, {});
  EXPECT_EQ(phase(), DrivePhase::lost);
  EXPECT_EQ(monitor_.report(now_).message, "the controller has not begun the trajectory for 5 s");
}

TEST_F(DriveMonitorTest, a_silent_controller_has_lost_the_trajectory_until_it_is_heard_again)
{
  begin_to_drive();
  now_ = ros::Time(105.2);
  EXPECT_EQ(phase(), DrivePhase::driving);
  now_ = ros::Time(105.4);
  EXPECT_EQ(phase(), DrivePhase::lost);
  EXPECT_FALSE(rests());
  hear(105.5, Tracking::DRIVING, kBegin);
  EXPECT_EQ(phase(), DrivePhase::driving);
}

TEST_F(DriveMonitorTest, after_a_stop_the_robot_rests_when_the_controller_rests_with_that_stop)
{
  begin_to_drive();
  const ros::Time stop(102.0);
  monitor_.sending_stop(stop, ros::Time(101.9));
  hear(101.95, Tracking::ARRIVED, kBegin);  // has not taken the stop yet: could still be about to go on
  EXPECT_FALSE(rests());
  hear(102.0, Tracking::STOPPING, stop);
  EXPECT_FALSE(rests());
  hear(102.5, Tracking::IDLE, stop);
  EXPECT_EQ(monitor_.at_rest_since(now_), ros::Time(102.5));
  EXPECT_EQ(phase(), DrivePhase::none);
}

TEST_F(DriveMonitorTest, a_controller_that_was_restarted_after_the_stop_rests_without_it)
{
  begin_to_drive();
  monitor_.sending_stop(ros::Time(102.0), ros::Time(101.9));
  hear(103.0, Tracking::IDLE, {});
  EXPECT_TRUE(rests());
}

TEST_F(DriveMonitorTest, a_controller_that_was_restarted_after_the_drive_rests)
{
  begin_to_drive();
  hear(103.0, Tracking::ARRIVED, kBegin);
  hear(104.0, Tracking::IDLE, {});
  EXPECT_EQ(monitor_.at_rest_since(now_), ros::Time(103.0));
  EXPECT_EQ(phase(), DrivePhase::arrived);
}

TEST_F(DriveMonitorTest, a_robot_that_does_not_come_to_rest_is_lost)
{
  begin_to_drive();
  monitor_.sending_stop(ros::Time(102.0), ros::Time(101.9));
  hear(107.1, Tracking::STOPPING, ros::Time(102.0), "no odom");
  EXPECT_EQ(phase(), DrivePhase::lost);
  EXPECT_EQ(monitor_.report(now_).message, "the controller has not come to rest for 5 s: no odom");
}

TEST_F(DriveMonitorTest, a_report_with_a_stamp_that_makes_no_sense_counts_when_it_comes)
{
  begin_to_drive();
  Tracking arrived;
  arrived.state = Tracking::ARRIVED;
  arrived.trajectory = kBegin;
  arrived.header.stamp = ros::TIME_MAX;
  monitor_.reported(arrived, ros::Time(103.0));
  EXPECT_EQ(monitor_.at_rest_since(ros::Time(103.0)), ros::Time(103.0));
  EXPECT_FALSE(monitor_.at_rest_since(ros::Time(109.0))) << "heard of long ago";
}

}  // namespace
}  // namespace fourwis
