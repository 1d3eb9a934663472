#include <linux/can/error.h>

#include "../can/bus/bus_laws.h"
#include "serial_adapter.h"

namespace fourwis::can
{
namespace
{

constexpr Frame kCommand{0x201, false, false, false, 2, {1, 2}};
constexpr char kCommandText[] = "t20120102";

/// The queue of the kernel follows the state of the controller after up to a second.
void wait_for_state(const std::string& state)
{
  run("timeout 10 sh -c 'until ip link show scan0 | grep -q state.'" + state + "'; do :; done'");
}

class ControllerTest : public testing::Test
{
protected:
  SerialAdapter adapter;
  std::unique_ptr<Bus> bus = open_bus("scan0");
};

TEST_F(ControllerTest, PassesFramesBothWays)
{
  ASSERT_EQ(bus->send(kCommand), BusStatus::ok) << bus->last_error();
  EXPECT_EQ(adapter.hear(), kCommandText);
  adapter.say("t1812AABB");
  EXPECT_EQ(next_frame(*bus), (Frame{0x181, false, false, false, 2, {0xaa, 0xbb}}));
}

TEST_F(ControllerTest, SaysItsStates)
{
  adapter.say("sw097100");
  const Frame warning = next_frame(*bus);
  EXPECT_TRUE(warning.error);
  EXPECT_TRUE(warning.id & CAN_ERR_CRTL);
  EXPECT_TRUE(warning.data[1] & (CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING));
  EXPECT_EQ(warning.data[7], 97) << "errors received";
  EXPECT_EQ(warning.data[6], 100) << "errors sent";
  adapter.say("sp000130");
  const Frame passive = next_frame(*bus);
  EXPECT_TRUE(passive.error);
  EXPECT_TRUE(passive.data[1] & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE));
  EXPECT_EQ(bus->send(kCommand), BusStatus::ok);
  EXPECT_EQ(adapter.hear(), kCommandText) << "passive is not off";
}

TEST_F(ControllerTest, BusOffSwallowsFramesUntilTheLinkGoesDownAndUp)
{
  wait_for_state("UP");
  adapter.say("sb000248");
  const Frame off = next_frame(*bus);
  EXPECT_TRUE(off.error);
  EXPECT_TRUE(off.id & CAN_ERR_BUSOFF);
  wait_for_state("DOWN");
  for (int n = 0; n < 3; ++n) EXPECT_EQ(bus->send(kCommand), BusStatus::ok);
  EXPECT_EQ(adapter.hear(), "");
  run("ip link set scan0 down && ip link set scan0 up");
  Frame frame;
  EXPECT_EQ(bus->receive(frame), BusStatus::down);
  ASSERT_TRUE(bus->recover()) << bus->last_error();
  ASSERT_EQ(bus->send(kCommand), BusStatus::ok) << bus->last_error();
  EXPECT_EQ(adapter.hear(), kCommandText);
  adapter.say("t1811CC");
  EXPECT_EQ(next_frame(*bus).data[0], 0xcc);
}

}  // namespace
}  // namespace fourwis::can
