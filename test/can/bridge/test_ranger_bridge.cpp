#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "can/bridge/bridge_connection.h"
#include "can/bus/memory_bus.h"
#include "fake_ranger.h"
#include "fourwis_navigation/vehicle/wheel_branches.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis::can
{
namespace
{

Robot with_wheels_of_a_ranger()
{
  Robot robot;
  robot.wheel_max_angle = M_PI_2;
  return robot;
}

BridgeOptions ranger_options()
{
  BridgeOptions options;
  options.protocol = Protocol::ranger;
  return options;
}

class RangerBridge : public testing::Test
{
protected:
  explicit RangerBridge(const BridgeOptions& options = ranger_options()) : options_(options) {}

  void tick()
  {
    ++ticks_;
    if (commands_ && ticks_ % 20 == 7)
    {
      ++wanted_.sequence;
      bridge_.command(wanted_, now(), now());
      connection_.flush(now());
    }
    connection_.exchange(now());
    if (ticks_ % 10 == 0) connection_.cycle(now());
    ranger_.step();
  }
  void pass(double seconds)
  {
    for (auto left = std::lround(seconds * 1e3); left > 0; --left) tick();
  }
  bool wait_for(const std::function<bool()>& condition)
  {
    for (int i = 0; i < 10000 && !condition(); ++i) tick();
    return condition();
  }
  void enable()
  {
    ASSERT_TRUE(wait_for([&] { return bridge_.report().stage == BridgeStage::ready; })) << cause();
    ASSERT_EQ(bridge_.enable(now()), nullptr);
    ASSERT_TRUE(wait_for([&] { return bridge_.report().stage == BridgeStage::enabled; })) << cause();
  }
  void command(Mode mode, double v, double phi)
  {
    commands_ = true;
    wanted_.mode = mode;
    const WheelMotion motion = wheel_motion(robot_, mode, v, phi);
    wanted_.motion = continue_branches(robot_, motion, {}).motion;
  }
  std::string cause() const { return text_of(bridge_.report().cause); }
  Fault fault() const { return bridge_.report().cause.fault; }
  double now() const { return 1e-3 * static_cast<double>(ticks_); }
  bool is_moving() const { return ranger_.speed != 0 || ranger_.yaw != 0 || ranger_.lateral != 0; }

  const Robot robot_ = with_wheels_of_a_ranger();
  const BridgeOptions options_;
  MemoryBus bus_;
  std::unique_ptr<MemoryBus::End> end_ = bus_.open(), ranger_end_ = bus_.open();
  FakeRanger ranger_{*ranger_end_};
  Bridge bridge_{robot_, options_};
  BridgeConnection connection_{bridge_, *end_};
  WheelCommand wanted_;
  bool commands_ = false;
  long ticks_ = 0;
};

TEST_F(RangerBridge, TakesControlAndStands)
{
  enable();
  EXPECT_TRUE(ranger_.in_control);
  pass(0.5);
  EXPECT_FALSE(is_moving());
}

TEST_F(RangerBridge, DualAckermannIsCommandedByTheInnerWheel)
{
  enable();
  for (const double phi : {0.5, -0.5})
  {
    command(Mode::ackermann, 0.4, phi);
    pass(2.0);
    EXPECT_EQ(ranger_.mode, 0);
    EXPECT_NEAR(ranger_.speed, 400, 1);
    const double inner = std::atan(0.34 / (0.34 / std::tan(std::abs(phi)) - 0.26));
    EXPECT_NEAR(ranger_.steering, std::copysign(1000.0 * inner, phi), 1.0) << cause();
    EXPECT_EQ(bridge_.report().stage, BridgeStage::enabled) << cause();
  }
}

TEST_F(RangerBridge, ParallelSpinAndSideSlipEachInItsMode)
{
  enable();
  command(Mode::parallel, -0.3, 0.7);
  pass(2.0);
  EXPECT_EQ(ranger_.mode, 1);
  EXPECT_NEAR(ranger_.speed, -300, 1);
  EXPECT_NEAR(ranger_.steering, 700, 1);
  command(Mode::lateral, 0.2, 0.0);
  pass(2.0);
  EXPECT_EQ(ranger_.mode, 4);
  EXPECT_NEAR(ranger_.lateral, 200, 1) << cause();
  command(Mode::spin, 0.3, 0.0);
  pass(3.0);
  EXPECT_EQ(ranger_.mode, 2);
  EXPECT_NEAR(ranger_.yaw, 1000.0 * 0.3 / (std::hypot(0.68, 0.52) / 2.0), 1.0) << cause();
  EXPECT_EQ(bridge_.report().stage, BridgeStage::enabled) << cause();
}

TEST_F(RangerBridge, NothingMovesWhileTheBaseChangesItsMode)
{
  enable();
  command(Mode::ackermann, 0.4, 0.0);
  pass(2.0);
  command(Mode::lateral, 0.4, 0.0);
  const auto slips = [&] {
    EXPECT_FALSE(ranger_.changing() && is_moving());
    return ranger_.lateral > 390;
  };
  EXPECT_TRUE(wait_for(slips)) << cause();
}

TEST_F(RangerBridge, LateralMotionWithSteeringIsRefusedByName)
{
  enable();
  command(Mode::lateral, 0.2, 0.3);
  pass(0.5);
  EXPECT_EQ(fault(), Fault::unsupported_motion);
  EXPECT_FALSE(is_moving());
}

TEST_F(RangerBridge, CommandsThatDoNotComeStopIt)
{
  enable();
  command(Mode::ackermann, 0.4, 0.0);
  pass(2.0);
  commands_ = false;
  pass(0.17);
  EXPECT_FALSE(is_moving());
  EXPECT_EQ(fault(), Fault::command_timeout);
}

TEST_F(RangerBridge, IsNotSteeredBeforeItHasACommand)
{
  ranger_.mode = 1;
  ranger_.steering = 700;
  enable();
  pass(1.0);
  EXPECT_EQ(ranger_.steering, 700);
  EXPECT_EQ(ranger_.motions, 0);
}

TEST_F(RangerBridge, StopsHoldTheAngles)
{
  const std::function<void()> ways[] = {[&] { commands_ = false; }, [&] { bridge_.disable(now()); },
                                        [&] { bridge_.press_emergency_stop(true, now()); },
                                        [&] { ranger_.vehicle = 2; }};
  for (const auto& stop : ways)
  {
    enable();
    command(Mode::parallel, 0.5, 0.7);
    pass(2.0);
    ASSERT_EQ(ranger_.speed, 500) << cause();
    stop();
    ASSERT_TRUE(wait_for([&] {
      EXPECT_EQ(ranger_.steering, 700);
      return !is_moving();
    }));
    pass(1.0);
    EXPECT_EQ(ranger_.steering, 700);
    EXPECT_FALSE(is_moving());
    commands_ = false;
    bridge_.press_emergency_stop(false, now());
    bridge_.clear_faults(now());
  }
}

TEST_F(RangerBridge, OutOfOperationNothingIsSent)
{
  enable();
  command(Mode::parallel, 0.5, 0.7);
  pass(2.0);
  bridge_.disable(now());
  ASSERT_TRUE(wait_for([&] { return bridge_.report().stage == BridgeStage::ready; }));
  const int motions = ranger_.motions;
  pass(1.0);
  EXPECT_EQ(ranger_.motions, motions);
}

TEST_F(RangerBridge, EnabledAnewItForgetsTheModeItHadBefore)
{
  enable();
  command(Mode::parallel, 0.5, 0.7);
  pass(2.0);
  bridge_.disable(now());
  commands_ = false;
  ASSERT_TRUE(wait_for([&] { return bridge_.report().stage == BridgeStage::ready; }));
  ranger_.mode = 0;  // by a remote control
  enable();
  pass(1.0);
  EXPECT_EQ(ranger_.mode, 0);
}

TEST_F(RangerBridge, WheelsThatRollDoNotSwingByHalfATurn)
{
  enable();
  command(Mode::parallel, 0.5, 1.55);
  pass(3.0);
  ASSERT_EQ(ranger_.speed, 500) << cause();
  wanted_.motion.angle.fill(1.60);
  ASSERT_TRUE(wait_for([&] {
    EXPECT_GE(ranger_.speed, 0);
    EXPECT_GE(ranger_.steering, 1500);
    return !is_moving();
  }));
  EXPECT_EQ(fault(), Fault::invalid_command);
}

TEST_F(RangerBridge, AtRestWheelsTakeTheBranchThatTheBaseCanReach)
{
  enable();
  command(Mode::parallel, 0.5, 1.7);
  pass(3.0);
  EXPECT_EQ(bridge_.report().stage, BridgeStage::enabled) << cause();
  EXPECT_EQ(ranger_.speed, -500);
  EXPECT_NEAR(ranger_.steering, 1700 - 3142, 1);
}

TEST_F(RangerBridge, SteeringThatIsStuckWhileItRollsIsAFault)
{
  enable();
  command(Mode::ackermann, 0.5, 0.15);
  pass(3.0);
  ASSERT_TRUE(is_moving()) << cause();
  ranger_.jammed = true;
  command(Mode::ackermann, 0.5, -0.15);
  pass(1.0);
  EXPECT_EQ(fault(), Fault::steering_stuck) << cause();
  EXPECT_FALSE(is_moving());
}

/// Between two commands there are at least 15 ms. A stop is sent at once.
TEST_F(RangerBridge, AStopIsSentAtOnceAfterACommand)
{
  enable();
  command(Mode::ackermann, 0.4, 0.0);
  pass(2.0);
  const int before = ranger_.motions;
  ASSERT_TRUE(wait_for([&] { return ranger_.motions > before; }));
  ASSERT_TRUE(is_moving());
  bridge_.press_emergency_stop(true, now());
  tick();
  EXPECT_FALSE(is_moving());
}

TEST_F(RangerBridge, FrequentCommandsAreSentAtALimitedRate)
{
  enable();
  for (const double v : {0.4, 0.0})
  {
    command(Mode::ackermann, v, 0.0);
    pass(2.0);
    commands_ = false;
    const int before = ranger_.motions;
    for (int i = 0; i < 300; ++i)
    {
      ++wanted_.sequence;
      bridge_.command(wanted_, now(), now());
      pass(0.003);
    }
    EXPECT_LE(ranger_.motions - before, 0.9 / 0.015 + 1.0);
    EXPECT_GE(ranger_.motions - before, 0.9 / 0.020) << "what the base wants";
    EXPECT_EQ(bridge_.report().stage, BridgeStage::enabled) << cause();
  }
}

TEST_F(RangerBridge, AfterALostLinkItIsToldToStandAtOnce)
{
  enable();
  command(Mode::parallel, 0.5, 0.7);
  pass(2.0);
  bridge_.set_link(false, now());
  pass(0.02);
  ASSERT_TRUE(is_moving());
  bridge_.set_link(true, now());
  pass(0.02);
  EXPECT_FALSE(is_moving());
  EXPECT_EQ(ranger_.steering, 700);
}

TEST_F(RangerBridge, IsNotStartedBeforeItHasToldItsMode)
{
  ranger_.tells_mode = false;
  pass(2.0);
  EXPECT_EQ(bridge_.report().stage, BridgeStage::start);
  pass(5.0);
  EXPECT_EQ(fault(), Fault::boot_timeout) << cause();
}

TEST_F(RangerBridge, NothingIsSentBeforeItHasListened)
{
  ticks_ = 5000;
  pass(0.1);
  EXPECT_EQ(bridge_.outbox().sent(), 0u);
  pass(0.1);
  EXPECT_GT(bridge_.outbox().sent(), 0u);
}

TEST_F(RangerBridge, NothingIsSentWhereAnotherMasterCommandsIt)
{
  for (int i = 0; i < 100; ++i)
  {
    ranger_end_->send(frame_of(0x111, {1, 0, 0, 0, 0, 0, 0, 0}));
    pass(0.01);
  }
  EXPECT_EQ(fault(), Fault::foreign_master);
  EXPECT_FALSE(ranger_.in_control);
  EXPECT_EQ(bridge_.outbox().sent(), 0u);
}

TEST_F(RangerBridge, FaultsOfTheBaseStopItAndHaveTheirNames)
{
  struct Case
  {
    std::function<void()> begin;
    Fault name;
  };
  std::vector<Case> cases = {{[&] { ranger_.silent = true; }, Fault::feedback_lost},
                             {[&] { ranger_.tells_state = false; }, Fault::heartbeat_lost},
                             {[&] { ranger_.tells_mode = false; }, Fault::feedback_lost},
                             {[&] { ranger_.vehicle = 2; }, Fault::drive_fault},
                             {[&] { ranger_.vehicle = 1; }, Fault::drive_disabled},
                             {[&] { ranger_.in_control = false; }, Fault::drive_disabled},
                             {[&] { ranger_.blocked = true; }, Fault::speed_not_followed}};
  for (const std::uint32_t id : {0x111u, 0x141u, 0x421u})
    cases.push_back({[this, id] { ranger_end_->send(frame_of(id, {1, 0, 0, 0, 0, 0, 0, 0})); }, Fault::foreign_master});
  for (const std::uint32_t id : {0x211u, 0x221u, 0x271u, 0x281u, 0x291u})
    cases.push_back({[this, id] { ranger_end_->send(frame_of(id, {0, 0})); }, Fault::malformed_frame});
  for (const Case& c : cases)
  {
    enable();
    command(Mode::ackermann, 0.4, 0.0);
    pass(2.0);
    EXPECT_TRUE(is_moving());
    c.begin();
    pass(0.5);
    EXPECT_EQ(fault(), c.name) << cause();
    EXPECT_FALSE(is_moving());
    ranger_.silent = false;
    ranger_.tells_mode = ranger_.tells_state = true;
    ranger_.blocked = false;
    ranger_.vehicle = 0;
    pass(5.0);
    EXPECT_FALSE(is_moving());
    ASSERT_EQ(bridge_.clear_faults(now()), nullptr);
  }
}

}  // namespace
}  // namespace fourwis::can
