#include <memory>

#include "drive_fixture.h"
#include "node_process.h"

namespace fourwis
{
namespace
{

/// The controller is killed and started again; the trajectory is latched and reaches the new one, too.
class Restart : public DriveFixture
{
protected:
  void SetUp() override
  {
    DriveFixture::SetUp();
    start_controller();
    connect();
  }

  void start_controller()
  {
    controller_ = std::make_unique<NodeProcess>("mpc_controller_node", std::vector<std::string>());
  }

  /// Without a controller the robot comes to rest, with a new one it stays there, and drives when it is told to.
  void expect_no_motion_until_a_new_trajectory()
  {
    controller_.reset();
    const Pose place = truth();
    wait_for_rest();
    EXPECT_LT(distance(truth(), place), 1.0);

    const Pose rest = truth();
    forget();
    start_controller();
    ASSERT_TRUE(wait_for_tracking([](const Tracking& t) { return t.state == Tracking::IDLE; }));
    ASSERT_TRUE(wait_until([this] { return trajectory_.getNumSubscribers() > 0; }));
    pass(2.0);
    EXPECT_LT(distance(truth(), rest), 1e-4);

    const Pose goal{rest.x + 1.0, 10, 0};
    ASSERT_TRUE(wait_for_state(Tracking::ARRIVED, send(plan(goal))));
    expect_at(goal);
  }

  std::unique_ptr<NodeProcess> controller_;
};

TEST_F(Restart, mid_drive_nothing_moves_until_there_is_a_new_trajectory)
{
  wait_for_motion(send(plan({18, 10, 0}, {Mode::ackermann})));
  expect_no_motion_until_a_new_trajectory();
}

TEST_F(Restart, nor_where_the_robot_is_still_at_the_beginning_of_the_old_one)
{
  ASSERT_TRUE(wait_for_state(Tracking::ALIGNING, send(plan({10, 14, 0}, {Mode::lateral}))));
  expect_no_motion_until_a_new_trajectory();
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_driving_restart");
}
