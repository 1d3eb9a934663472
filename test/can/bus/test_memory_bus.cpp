#include "can/bus/memory_bus.h"

#include <linux/can/error.h>

#include <cmath>

#include "../../support/random.h"
#include "bus_laws.h"
#include "fourwis_navigation/can/protocol/frame_bits.h"

namespace fourwis::can
{
namespace
{

class MemoryRig
{
public:
  std::unique_ptr<Bus> open()
  {
    auto end = bus_.open();
    end->set_link(link_);
    ends_.push_back(end.get());
    return end;
  }
  void take_down() { set_link(Link::down); }
  void bring_up() { set_link(Link::up); }

private:
  void set_link(Link link)
  {
    link_ = link;
    for (MemoryBus::End* end : ends_) end->set_link(link);
  }

  MemoryBus bus_;
  std::vector<MemoryBus::End*> ends_;
  Link link_ = Link::up;
};
INSTANTIATE_TYPED_TEST_SUITE_P(Memory, BusLaws, MemoryRig);

constexpr double kBitRate = 500e3;
const MemoryBusOptions kDisciplined{kBitRate, 12, 4096};

Frame plain(std::uint32_t id, std::uint8_t size)
{
  return {id, false, false, false, size, {}};
}

TEST(FrameBits, TheCycleOfEightDrivesIsTheKnownBudget)
{
  const int cycle = worst_case_bits(plain(0x80, 0)) + 8 * worst_case_bits(plain(0x201, 7)) +
                    8 * worst_case_bits(plain(0x181, 3)) + 8 * worst_case_bits(plain(0x281, 8));
  EXPECT_EQ(cycle, 2815);
  EXPECT_EQ(worst_case_bits({1, true, false, false, 8, {}}), 160);
  EXPECT_EQ(worst_case_bits({1, false, true, false, 8, {}}), worst_case_bits(plain(1, 0)));
}

TEST(DisciplinedMemoryBus, FramesTakeTheirTimeAndTheSmallestIdGoesFirst)
{
  MemoryBus bus(kDisciplined);
  const auto a = bus.open(), b = bus.open(), reader = bus.open();
  bus.advance(1.0);
  const std::uint32_t order[] = {0x300, 0x100, 0x200, 0x301};  // 0x300 is on the bus already when the others come
  a->send(plain(0x300, 8));
  a->send(plain(0x200, 8));
  b->send(plain(0x100, 8));
  b->send(plain(0x301, 8));
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(bus.next_arrival(), 1.0 + (k + 1) * 135.0 / kBitRate, 1e-12);
    bus.advance(bus.next_arrival() - 1e-9);
    expect_silence(*reader);
    bus.advance(bus.next_arrival());
    EXPECT_EQ(next_frame(*reader).id, order[k]);
  }
  EXPECT_TRUE(std::isinf(bus.next_arrival()));
}

TEST(DisciplinedMemoryBus, AFullTransmitQueueRefuses)
{
  MemoryBus bus(kDisciplined);
  const auto sender = bus.open(), reader = bus.open();
  for (std::uint8_t n = 0; n < 12; ++n) ASSERT_EQ(sender->send({0x10, false, false, false, 1, {n}}), BusStatus::ok);
  EXPECT_EQ(sender->send(plain(0x10, 0)), BusStatus::would_block);
  EXPECT_EQ(sender->counters().refused, 1u);
  bus.advance(1.0);
  EXPECT_EQ(sender->waiting(), 0u);
  for (std::uint8_t n = 0; n < 12; ++n) EXPECT_EQ(next_frame(*reader).data[0], n);
  EXPECT_EQ(sender->send(plain(0x10, 0)), BusStatus::ok);
}

/// For any order of sends and steps of time, one frame at a time is on the bus, and the frames of each end arrive in
/// order.
TEST(DisciplinedMemoryBus, CarriesNoMoreThanItsBitRate)
{
  Random random(5);
  MemoryBus bus(kDisciplined);
  std::vector<std::unique_ptr<MemoryBus::End>> senders;
  for (int i = 0; i < 3; ++i) senders.push_back(bus.open());
  const auto reader = bus.open();
  std::vector<std::uint8_t> sent(3, 0), read(3, 0);
  double now = 0.0, carried = 0.0;
  for (int step = 0; step < 20000; ++step)
  {
    const std::size_t i = static_cast<std::size_t>(random.whole(0, 2));
    const Frame next{static_cast<std::uint32_t>(i), random.chance(0.5), false, false, 1, {sent[i]}};
    if (senders[i]->send(next) == BusStatus::ok) ++sent[i];
    now += random.between(0.0, 2e-4);
    bus.advance(now);
    Frame frame;
    while (reader->receive(frame) == BusStatus::ok)
    {
      EXPECT_EQ(frame.data[0], read[frame.id]++);
      carried += worst_case_bits(frame) / kBitRate;
      ASSERT_LE(carried, now);
    }
  }
  EXPECT_GT(carried, 0.9 * now);
}

TEST(MemoryBusFaults, OneInterfaceBreaksAndTheOthersGoOn)
{
  MemoryBus bus;
  const auto robot = bus.open(), drive = bus.open(), other = bus.open();
  for (Link link : {Link::down, Link::gone})
  {
    robot->set_link(link);
    expect_connected(*drive, *other);
    EXPECT_FALSE(robot->recover());
    robot->set_link(Link::up);
    EXPECT_TRUE(robot->recover());
    expect_silence(*robot);
    robot->send(plain(1, 0));
    EXPECT_EQ(next_frame(*drive).id, 1u);
    EXPECT_EQ(next_frame(*other).id, 1u);
  }
}

TEST(MemoryBusFaults, WhatWaitedWhenTheLinkBrokeIsLost)
{
  MemoryBus bus(kDisciplined);
  const auto robot = bus.open(), drive = bus.open();
  robot->send(plain(1, 8));
  robot->send(plain(2, 8));
  robot->set_link(Link::down);
  EXPECT_TRUE(std::isinf(bus.next_arrival()));
  robot->set_link(Link::up);
  bus.advance(1.0);
  expect_silence(*drive);
}

TEST(MemoryBusFaults, AFullQueueRefusesEveryFrame)
{
  MemoryBus bus;
  const auto robot = bus.open(), drive = bus.open();
  robot->set_full(true);
  for (int n = 0; n < 3; ++n) EXPECT_EQ(robot->send(plain(1, 0)), BusStatus::would_block);
  EXPECT_EQ(robot->counters().refused, 3u);
  expect_silence(*drive);
  robot->set_full(false);
  expect_connected(*robot, *drive);
}

TEST(MemoryBusFaults, BusOffSwallowsFramesUntilTheControllerRestarts)
{
  MemoryBus bus;
  const auto robot = bus.open(), drive = bus.open();
  robot->bus_off();
  const Frame said = next_frame(*robot);
  EXPECT_TRUE(said.error);
  EXPECT_EQ(said.id, static_cast<std::uint32_t>(CAN_ERR_BUSOFF));
  EXPECT_EQ(robot->send(plain(1, 0)), BusStatus::ok);
  EXPECT_EQ(drive->send(plain(2, 0)), BusStatus::ok);
  expect_silence(*drive);
  expect_silence(*robot);
  robot->restart();
  EXPECT_EQ(next_frame(*robot).id, static_cast<std::uint32_t>(CAN_ERR_RESTARTED));
  expect_connected(*robot, *drive);
}

TEST(MemoryBusFaults, InjectedFramesHaveNoSender)
{
  MemoryBus bus;
  const auto robot = bus.open(), drive = bus.open();
  robot->inject(plain(7, 0));
  EXPECT_EQ(next_frame(*robot).id, 7u);
  expect_silence(*drive);
}

TEST(MemoryBus, RejectsUnusableOptions)
{
  EXPECT_THROW(MemoryBus({-1.0, 12, 12}), std::invalid_argument);
  EXPECT_THROW(MemoryBus({NAN, 12, 12}), std::invalid_argument);
  EXPECT_THROW(MemoryBus({0.0, 0, 12}), std::invalid_argument);
  EXPECT_THROW(MemoryBus({0.0, 12, 0}), std::invalid_argument);
  MemoryBus bus;
  bus.advance(1.0);
  EXPECT_THROW(bus.advance(0.5), std::invalid_argument);
}

}  // namespace
}  // namespace fourwis::can
