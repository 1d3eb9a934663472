#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "../support/sentences.h"
#include "fourwis_navigation/model/fingerprint.h"
#include "ros/control_loop.h"
#include "ros/drive_conversions.h"

namespace fourwis
{
namespace
{

constexpr double kBegin = 100.0;  ///< when the first measurement is made [s]

/// A robot that stands at the map's origin and ignores commands.
class ControlLoopTest : public testing::Test
{
protected:
  ControlLoopTest()
  {
    std_msgs::Header header;
    header.frame_id = "map";
    tf_.setTransform(to_message(Pose{}, header, "odom"), "test", true);
  }

  /// One pair; what came of it.
  std::optional<ControlStep> measure(double time)
  {
    nav_msgs::Odometry odometry;
    odometry.header.stamp = ros::Time(time);
    odometry.header.frame_id = "odom";
    odometry.child_frame_id = "base_link";
    odometry.pose.pose = to_message(Pose{});
    WheelState wheels;
    wheels.state = base_;
    return loop_.measured(odometry, to_message(wheels, odometry.header.stamp, base_says_));
  }

  /// Pairs at 100 Hz from one time up to another; the steps that came of them.
  std::vector<ControlStep> measure(double from, double to)
  {
    std::vector<ControlStep> steps;
    for (int i = 0; from + i * 0.01 < to - 1e-6; ++i)
      if (const auto step = measure(from + i * 0.01)) steps.push_back(*step);
    return steps;
  }

  /// A metre forward.
  static fourwis_navigation::ModeTrajectory trajectory(double stamp, const std::string& frame = "map")
  {
    std_msgs::Header header;
    header.frame_id = frame;
    header.stamp = ros::Time(stamp);
    return to_message(Robot(),
                      Trajectory{{0.0, Mode::ackermann, 0, 0, 0, 0, 0, 1, 0},
                                 {1.0, Mode::ackermann, 0.5, 0, 0, 1, 0, -1, 0},
                                 {2.0, Mode::ackermann, 1.0, 0, 0, 0, 0, 0, 0}},
                      header);
  }
  static fourwis_navigation::ModeTrajectory stop(double stamp)
  {
    fourwis_navigation::ModeTrajectory stop = trajectory(stamp);
    stop.points.clear();
    return stop;
  }

  /// What is said of it when it is refused right away.
  std::string refusal(const fourwis_navigation::ModeTrajectory& trajectory)
  {
    refusals_.clear();
    loop_.take(trajectory);
    return refusals_.empty() ? "" : refusals_.back();
  }

  BaseState base_ = BaseState::enabled;
  std::string base_says_;
  tf2::BufferCore tf_;
  std::vector<std::string> refusals_;
  ControlLoop loop_{{}, tf_, [this](const ros::Time&, const std::string& why) { refusals_.push_back(why); }};
};

TEST_F(ControlLoopTest, steps_at_the_controllers_frequency_on_pairs_that_come_faster)
{
  const std::vector<ControlStep> steps = measure(kBegin, kBegin + 1.0);
  ASSERT_EQ(steps.size(), 50u);
  for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_NEAR((steps[i].stamp - steps[i - 1].stamp).toSec(), 0.02, 1e-6);
}

TEST_F(ControlLoopTest, without_a_trajectory_it_tells_the_wheels_to_stop)
{
  for (const ControlStep& step : measure(kBegin, kBegin + 0.1))
  {
    EXPECT_EQ(step.output.state, TrackState::idle);
    EXPECT_EQ(step.output.command.mode, Mode::none);
    EXPECT_TRUE(step.trajectory.isZero());
  }
}

TEST_F(ControlLoopTest, a_trajectory_begins_with_the_first_step_that_is_not_before_its_stamp)
{
  measure(kBegin, kBegin + 0.1);
  loop_.take(trajectory(kBegin + 0.3));
  for (const ControlStep& step : measure(kBegin + 0.1, kBegin + 0.6))
    EXPECT_EQ(step.output.state == TrackState::idle, step.stamp < ros::Time(kBegin + 0.3)) << step.stamp;
  EXPECT_TRUE(refusals_.empty());
}

TEST_F(ControlLoopTest, a_stop_ends_what_is_driven_and_what_waits)
{
  measure(kBegin, kBegin + 0.1);
  loop_.take(trajectory(kBegin));
  EXPECT_EQ(measure(kBegin + 0.1, kBegin + 0.2).back().output.state, TrackState::aligning);
  loop_.take(trajectory(kBegin + 0.5));
  loop_.take(stop(kBegin + 0.2));
  for (const ControlStep& step : measure(kBegin + 0.2, kBegin + 1.0))
  {
    EXPECT_NE(step.output.state, TrackState::aligning);
    EXPECT_EQ(step.trajectory, ros::Time(kBegin + 0.2));
    EXPECT_EQ(step.output.command.mode, Mode::none);
  }
}

TEST_F(ControlLoopTest, a_stop_that_waits_is_not_postponed_by_what_comes_after_it)
{
  measure(kBegin, kBegin + 0.1);
  loop_.take(trajectory(kBegin));
  measure(kBegin + 0.1, kBegin + 0.2);
  loop_.take(stop(kBegin + 0.3));
  loop_.take(stop(kBegin + 0.4));
  loop_.take(trajectory(kBegin + 5.0));
  EXPECT_EQ(measure(kBegin + 0.2, kBegin + 0.3).back().output.state, TrackState::aligning);
  const ControlStep step = measure(kBegin + 0.3, kBegin + 0.4).front();
  EXPECT_EQ(step.output.command.mode, Mode::none);
  EXPECT_EQ(step.trajectory, ros::Time(kBegin + 0.4)) << "named after the last one";
  EXPECT_EQ(measure(kBegin + 5.0, kBegin + 5.1).front().trajectory, ros::Time(kBegin + 5.0));
}

TEST_F(ControlLoopTest, says_whether_the_base_lets_itself_be_driven)
{
  EXPECT_TRUE(measure(kBegin)->enabled);
  base_ = BaseState::ready;
  EXPECT_FALSE(measure(kBegin + 0.1)->enabled);
}

TEST_F(ControlLoopTest, a_stop_that_comes_before_the_first_measurement_counts_as_well)
{
  loop_.take(stop(kBegin - 1.0));
  EXPECT_EQ(measure(kBegin, kBegin + 0.1).back().trajectory, ros::Time(kBegin - 1.0));
}

TEST_F(ControlLoopTest, a_stop_of_another_clock_does_not_wait_for_it)
{
  measure(kBegin, kBegin + 0.1);
  loop_.take(trajectory(kBegin));
  measure(kBegin + 0.1, kBegin + 0.2);
  loop_.take(stop(kBegin + 5.0));
  EXPECT_EQ(measure(kBegin + 0.2, kBegin + 0.3).front().trajectory, ros::Time(kBegin + 5.0));
}

TEST_F(ControlLoopTest, stamps_of_no_sense_do_no_harm)
{
  measure(kBegin, kBegin + 0.1);
  EXPECT_TRUE(says(refusal(trajectory(4294967295.0)), "s after the newest odometry"));
  measure(4294967295.0);
  EXPECT_FALSE(loop_.watch(ros::Time(kBegin)));
  loop_.take(stop(4294967295.0));
  EXPECT_FALSE(measure(kBegin + 0.2, kBegin + 0.3).empty());
}

TEST_F(ControlLoopTest, refuses_what_it_cannot_drive_and_says_why)
{
  EXPECT_TRUE(says(refusal(trajectory(kBegin)), "came before odometry and wheel states"));
  measure(kBegin, kBegin + 1.0);
  EXPECT_TRUE(says(refusal(trajectory(kBegin - 1.0)), "was planned 1 s before the controller started"));
  EXPECT_TRUE(says(refusal(trajectory(kBegin + 20.0)), "s after the newest odometry, expected at most 10 s"));
  EXPECT_TRUE(says(refusal(trajectory(kBegin + 1.0, "odom")), "'odom', expected global_frame = 'map'"));

  auto broken = trajectory(kBegin + 1.0);
  broken.points[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(broken), "");
  measure(kBegin + 1.0, kBegin + 1.1);
  ASSERT_EQ(refusals_.size(), 1u);
  EXPECT_TRUE(says(refusals_[0], "no finite number"));
}

TEST_F(ControlLoopTest, refuses_a_trajectory_of_another_robot)
{
  measure(kBegin, kBegin + 1.0);
  Robot longer;
  longer.length += 0.01;
  auto foreign = trajectory(kBegin + 1.0);
  foreign.fingerprint = fingerprint(longer);
  EXPECT_TRUE(says(refusal(foreign), "was planned for another robot: fingerprint is '" + fingerprint(longer) +
                                         "', expected '" + fingerprint(Robot()) + "'"));
  EXPECT_TRUE(says(refusal(foreign), "give planner and controller the same robot.yaml"));
  foreign.fingerprint = "";
  EXPECT_TRUE(says(refusal(foreign), "names no robot: fingerprint is ''"));
}

TEST_F(ControlLoopTest, a_stop_needs_no_robot)
{
  measure(kBegin, kBegin + 0.1);
  loop_.take(trajectory(kBegin));
  EXPECT_EQ(measure(kBegin + 0.1, kBegin + 0.2).back().output.state, TrackState::aligning);
  auto nameless = stop(kBegin + 0.2);
  nameless.fingerprint = "";
  EXPECT_EQ(refusal(nameless), "");
  EXPECT_EQ(measure(kBegin + 0.2, kBegin + 0.3).back().trajectory, ros::Time(kBegin + 0.2));
}

TEST_F(ControlLoopTest, passes_on_why_the_base_is_not_enabled)
{
  base_says_ = "enabled, and as talkative";
  EXPECT_EQ(measure(kBegin)->problem, "");
  base_ = BaseState::ready;
  base_says_ = "emergency stop pressed";
  EXPECT_EQ(measure(kBegin + 0.1)->problem, "emergency stop pressed");
}

TEST_F(ControlLoopTest, goes_on_without_measurements_only_to_stop)
{
  EXPECT_FALSE(loop_.watch(ros::Time(kBegin)));
  measure(kBegin, kBegin + 0.1);
  loop_.take(trajectory(kBegin));
  measure(kBegin + 0.1, kBegin + 0.2);
  EXPECT_FALSE(loop_.watch(ros::Time(kBegin + 0.2)));
  const auto step = loop_.watch(ros::Time(kBegin + 0.5));
  ASSERT_TRUE(step);
  EXPECT_EQ(step->output.command.mode, Mode::none);
  EXPECT_TRUE(says(step->problem, "no odom and wheel_states of one stamp"));
}

TEST_F(ControlLoopTest, when_time_goes_back_it_begins_anew)
{
  measure(kBegin, kBegin + 0.1);
  loop_.take(trajectory(kBegin));
  measure(kBegin + 0.1, kBegin + 0.2);
  const std::vector<ControlStep> steps = measure(kBegin - 50.0, kBegin - 49.9);
  ASSERT_FALSE(steps.empty());
  for (const ControlStep& step : steps) EXPECT_EQ(step.output.state, TrackState::idle);
  EXPECT_TRUE(says(refusal(trajectory(kBegin - 60.0)), "before the controller started"));
}

TEST_F(ControlLoopTest, what_comes_late_does_not_end_the_drive)
{
  measure(kBegin, kBegin + 0.1);
  loop_.take(trajectory(kBegin));
  measure(kBegin + 0.1, kBegin + 0.2);
  EXPECT_FALSE(measure(kBegin + 0.12));
  const ControlStep step = measure(kBegin + 0.2, kBegin + 0.3).back();
  EXPECT_EQ(step.output.state, TrackState::aligning);
  EXPECT_EQ(step.trajectory, ros::Time(kBegin));
}

TEST_F(ControlLoopTest, a_trajectory_that_interrupts_another_is_not_at_rest_before_it_begins)
{
  measure(kBegin, kBegin + 0.1);
  loop_.take(trajectory(kBegin));
  measure(kBegin + 0.1, kBegin + 0.2);
  loop_.take(trajectory(kBegin + 0.3));
  for (const ControlStep& step : measure(kBegin + 0.3, kBegin + 1.0))
  {
    EXPECT_EQ(step.trajectory, ros::Time(kBegin + 0.3));
    EXPECT_TRUE(step.output.state == TrackState::stopping || step.output.state == TrackState::aligning);
  }
}

}  // namespace
}  // namespace fourwis
