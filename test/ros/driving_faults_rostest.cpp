#include "drive_fixture.h"

namespace fourwis
{
namespace
{

const ModeSet kAckermann{Mode::ackermann}, kLateral{Mode::lateral};

/// Something breaks on the way.
class Faults : public DriveFixture
{
protected:
  void SetUp() override
  {
    DriveFixture::SetUp();
    connect();
  }
};

struct Loss
{
  std::string fault;
  std::string said;  ///< part of the sentence
};

class Lost : public Faults, public testing::WithParamInterface<Loss>
{};

TEST_P(Lost, stops_it_soon_and_says_why_and_afterwards_it_drives_again)
{
  const ros::Time drive = send(plan({18, 10, 0}, kAckermann));
  wait_for_motion(drive);
  const Pose place = truth();
  ASSERT_TRUE(inject(GetParam().fault).success);
  const auto failed = wait_for_state(Tracking::FAILED, drive);
  ASSERT_TRUE(failed);
  EXPECT_NE(failed->message.find(GetParam().said), std::string::npos) << failed->message;
  wait_for_rest();
  // At 1 m/s: 0.1 s until it is noticed, the latency, and braking.
  EXPECT_LT(distance(truth(), place), 1.0);

  repair();
  forget();
  pass(0.5);
  const Pose goal{truth().x - 1.0, 10, 0};
  ASSERT_TRUE(wait_for_state(Tracking::ARRIVED, send(plan(goal, kAckermann))));
  expect_at(goal);
}

INSTANTIATE_TEST_SUITE_P(Things, Lost,
                         testing::Values(Loss{"lost_odometry", "pose"}, Loss{"lost_wheel_states", "wheel"},
                                         Loss{"lost_localization", "transform"}),
                         [](const auto& given) { return given.param.fault; });

TEST_F(Faults, a_wheel_that_does_not_align_ends_the_drive_where_it_began)
{
  ASSERT_TRUE(inject("stuck_steering", 2).success);
  const ros::Time drive = send(plan({10, 14, 0}, kLateral));
  const auto failed = wait_for_state(Tracking::FAILED, drive);
  ASSERT_TRUE(failed);
  EXPECT_FALSE(failed->message.empty());
  EXPECT_LT(distance(truth(), kMiddle), 1e-3);
}

TEST_F(Faults, an_odometry_that_jumps_stops_it)
{
  const ros::Time drive = send(plan({18, 10, 0}, kAckermann));
  wait_for_motion(drive);
  const Pose place = truth();
  InjectFault::Request jump;
  jump.kind = "odometry_jump";
  jump.y = 1.0;
  ASSERT_TRUE(inject(jump).success);
  const auto failed = wait_for_state(Tracking::FAILED, drive);
  ASSERT_TRUE(failed);
  EXPECT_FALSE(failed->message.empty());
  wait_for_rest();
  EXPECT_LT(distance(truth(), place), 1.0);
}

TEST_F(Faults, what_cannot_be_broken_is_refused)
{
  EXPECT_FALSE(inject("gravity").success);
  EXPECT_NE(inject("gravity").message.find("'gravity'"), std::string::npos);
  EXPECT_NE(inject("dead_drive", 4).message.find("wheel is 4, expected a number from 0 to 3"), std::string::npos);
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_driving_faults");
}
