#include "../can/bus/bus_laws.h"
#include "vcan_rig.h"

namespace fourwis::can
{
namespace
{

bool becomes_readable(const Bus& bus)
{
  pollfd wait{bus.descriptor(), POLLIN, 0};
  return poll(&wait, 1, 10000) > 0;
}

class InterfaceTest : public testing::Test
{
protected:
  VcanRig rig;
  std::unique_ptr<Bus> robot = rig.open(), drive = rig.open();
  Frame frame;
};

TEST_F(InterfaceTest, DownWakesTheReader)
{
  rig.take_down();
  EXPECT_TRUE(becomes_readable(*robot));
  EXPECT_EQ(robot->receive(frame), BusStatus::down);
  EXPECT_EQ(robot->last_error(), "vcan0: the link is down");
  EXPECT_EQ(robot->descriptor(), -1);
}

TEST_F(InterfaceTest, AShortBreakBetweenTwoFramesIsNoticed)
{
  rig.take_down();
  rig.bring_up();
  EXPECT_EQ(robot->send(numbered(0, 0)), BusStatus::down);
  EXPECT_EQ(drive->receive(frame), BusStatus::down);
  EXPECT_TRUE(robot->recover() && drive->recover());
  expect_connected(*robot, *drive);
}

TEST_F(InterfaceTest, DeletedAndAddedAgain)
{
  rig.remove();
  EXPECT_TRUE(becomes_readable(*robot));
  EXPECT_EQ(robot->receive(frame), BusStatus::down);
  EXPECT_EQ(drive->send(numbered(0, 0)), BusStatus::down);
  EXPECT_FALSE(robot->recover());
  EXPECT_EQ(robot->last_error(), "vcan0: there is no such interface");
  rig.add();
  EXPECT_TRUE(robot->recover() && drive->recover());
  expect_connected(*robot, *drive);
}

TEST_F(InterfaceTest, DeletedAndAddedAgainUnnoticed)
{
  rig.remove();
  rig.add();
  EXPECT_EQ(robot->send(numbered(0, 0)), BusStatus::down);
  EXPECT_EQ(drive->receive(frame), BusStatus::down);
  EXPECT_TRUE(robot->recover() && drive->recover());
  expect_connected(*robot, *drive);
}

TEST_F(InterfaceTest, MissingAtTheStart)
{
  rig.remove();
  const auto early = rig.open();
  EXPECT_EQ(early->send(numbered(0, 0)), BusStatus::down);
  EXPECT_EQ(early->last_error(), "vcan0: there is no such interface");
  rig.add();
  EXPECT_TRUE(early->recover());
  const auto late = rig.open();
  expect_connected(*early, *late);
}

TEST_F(InterfaceTest, OtherInterfacesAreOtherBuses)
{
  const auto other = open_bus("vcan1");
  expect_connected(*robot, *drive);
  expect_silence(*other);
}

}  // namespace
}  // namespace fourwis::can
