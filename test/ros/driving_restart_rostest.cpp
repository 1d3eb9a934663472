#include <memory>

#include "drive_fixture.h"
#include "node_process.h"

namespace fourwis
{
namespace
{

TEST_F(DriveFixture, a_controller_that_is_restarted_mid_drive_does_not_move_until_there_is_a_new_trajectory)
{
  const std::vector<std::string> arguments;
  const auto start_controller = [&] { return std::make_unique<NodeProcess>("mpc_controller_node", arguments); };
  auto controller = start_controller();
  connect();
  const ros::Time drive = send(plan({18, 10, 0}, {true, false, false}));
  wait_for_motion(drive);

  controller.reset();
  const Pose place = truth();
  wait_for_rest();
  EXPECT_LT(distance(truth(), place), 1.0);

  // The trajectory is latched: it reaches the new controller, too.
  const Pose rest = truth();
  forget();
  controller = start_controller();
  ASSERT_TRUE(wait_for_tracking([](const Tracking& t) { return t.state == Tracking::IDLE; }));
  ASSERT_TRUE(wait_until([this] { return trajectory_.getNumSubscribers() > 0; }));
  pass(2.0);
  EXPECT_LT(distance(truth(), rest), 1e-4);

  const Pose goal{rest.x + 1.0, 10, 0};
  ASSERT_TRUE(wait_for_state(Tracking::ARRIVED, send(plan(goal))));
  expect_at(goal);
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_driving_restart");
}
