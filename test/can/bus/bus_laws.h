#pragma once

#include <gtest/gtest.h>
#include <poll.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{

/// The rules that every kind of bus keeps. A Rig is one bus of a kind, with
///   std::unique_ptr<Bus> open();   opens another end of it
///   void take_down();              takes the bus down for all ends
///   void bring_up();               brings it up again
template <typename Rig>
class BusLaws : public testing::Test
{
protected:
  Rig rig;
};
TYPED_TEST_SUITE_P(BusLaws);

/// The next frame that arrives; the test fails after 10 s without one.
inline Frame next_frame(Bus& bus)
{
  Frame frame;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  BusStatus status = bus.receive(frame);
  while (status == BusStatus::would_block && bus.descriptor() >= 0 && std::chrono::steady_clock::now() < deadline)
  {
    pollfd wait{bus.descriptor(), POLLIN, 0};
    poll(&wait, 1, 100);
    status = bus.receive(frame);
  }
  EXPECT_EQ(status, BusStatus::ok) << "no frame arrived: " << bus.last_error();
  return frame;
}

inline void expect_silence(Bus& bus)
{
  Frame frame;
  EXPECT_EQ(bus.receive(frame), BusStatus::would_block) << "id " << frame.id;
}

/// Checks that frames pass between these two ends in both directions.
inline void expect_connected(Bus& a, Bus& b)
{
  const Frame hello{0x123, false, false, false, 1, {1}}, answer{0x124, false, false, false, 1, {2}};
  ASSERT_EQ(a.send(hello), BusStatus::ok) << a.last_error();
  EXPECT_EQ(next_frame(b), hello);
  ASSERT_EQ(b.send(answer), BusStatus::ok) << b.last_error();
  EXPECT_EQ(next_frame(a), answer);
}

/// Frame number n of a sender; successive ones are of different kinds.
inline Frame numbered(int sender, int n)
{
  Frame frame;
  frame.extended = n % 3 == 1;
  frame.remote = n % 7 == 3;
  frame.id = static_cast<std::uint32_t>(sender) + (frame.extended ? 0x1abcd00 : 0x200);
  frame.size = static_cast<std::uint8_t>(n % 9);
  if (!frame.remote)
    for (std::uint8_t i = 0; i < frame.size; ++i) frame.data[i] = static_cast<std::uint8_t>(n >> (8 * (i % 2)));
  return frame;
}

TYPED_TEST_P(BusLaws, EveryOtherEndGetsEveryFrameOnceInOrderAndNoneComesBack)
{
  std::vector<std::unique_ptr<Bus>> ends;
  for (int i = 0; i < 4; ++i) ends.push_back(this->rig.open());
  for (int n = 0; n < 100; ++n)
    for (std::size_t sender = 0; sender < 2; ++sender)
    {
      const Frame frame = numbered(static_cast<int>(sender), n);
      ASSERT_EQ(ends[sender]->send(frame), BusStatus::ok) << ends[sender]->last_error();
      for (std::size_t other = 1; other < 4; ++other) EXPECT_EQ(next_frame(*ends[(sender + other) % 4]), frame);
    }
  for (const auto& end : ends) expect_silence(*end);
  EXPECT_EQ(ends[0]->counters().sent, 100u);
  EXPECT_EQ(ends[0]->counters().received, 100u);
  EXPECT_EQ(ends[3]->counters().received, 200u);
  EXPECT_EQ(ends[3]->counters().dropped, 0u);
}

TYPED_TEST_P(BusLaws, AnEmptyBusDoesNotBlock)
{
  const auto alone = this->rig.open();
  expect_silence(*alone);
  EXPECT_EQ(alone->send(numbered(0, 0)), BusStatus::ok) << alone->last_error();
  expect_silence(*alone);
  EXPECT_TRUE(alone->recover());
  EXPECT_EQ(alone->last_error(), "");
}

TYPED_TEST_P(BusLaws, EndsComeAndGo)
{
  const auto first = this->rig.open();
  for (int n = 0; n < 20; ++n)
  {
    const auto second = this->rig.open();
    expect_connected(*first, *second);
  }
  EXPECT_EQ(first->send(numbered(0, 0)), BusStatus::ok) << first->last_error();
}

TYPED_TEST_P(BusLaws, AnErrorFrameReachesTheOthersAsOne)
{
  const auto controller = this->rig.open(), listener = this->rig.open();
  const Frame bus_off{0x40, false, false, true, 8, {}};
  ASSERT_EQ(controller->send(bus_off), BusStatus::ok);
  EXPECT_EQ(next_frame(*listener), bus_off);
}

TYPED_TEST_P(BusLaws, WhatIsNoFrameIsNotSent)
{
  const auto sender = this->rig.open(), receiver = this->rig.open();
  const Frame too_long{0x1, false, false, false, 9, {}}, wide{0x800, false, false, false, 0, {}},
      wider{0x20000000, true, false, false, 0, {}}, both{0x40, false, true, true, 8, {}};
  for (const Frame& frame : {too_long, wide, wider, both})
  {
    EXPECT_EQ(sender->send(frame), BusStatus::failed);
    EXPECT_NE(sender->last_error(), "");
  }
  expect_silence(*receiver);
  EXPECT_EQ(sender->counters().sent, 0u);
  EXPECT_EQ(sender->send(numbered(0, 0)), BusStatus::ok);
  EXPECT_EQ(sender->last_error(), "");
}

/// Loses its frames, in order and counted, while the others lose none.
TYPED_TEST_P(BusLaws, AnEndThatDoesNotReadDoesNotDelayTheOthers)
{
  const auto sender = this->rig.open(), reader = this->rig.open(), sleeper = this->rig.open();
  constexpr int kFrames = 20000;
  for (int n = 0; n < kFrames; ++n)
  {
    ASSERT_EQ(sender->send(numbered(0, n)), BusStatus::ok) << sender->last_error();
    ASSERT_EQ(next_frame(*reader), numbered(0, n));
  }
  Frame frame;
  for (int n = 0; sleeper->receive(frame) == BusStatus::ok; ++n)
    while (n < kFrames && frame != numbered(0, n)) ++n;
  ASSERT_EQ(sender->send(numbered(0, 1)), BusStatus::ok) << sender->last_error();
  EXPECT_EQ(next_frame(*sleeper), numbered(0, 1));
  EXPECT_GT(sleeper->counters().dropped, 0u);
  EXPECT_EQ(sleeper->counters().received + sleeper->counters().dropped, kFrames + 1u);
}

TYPED_TEST_P(BusLaws, DownStaysDownUntilItRecoversAndOldFramesAreGone)
{
  const auto a = this->rig.open(), b = this->rig.open();
  expect_connected(*a, *b);
  ASSERT_EQ(a->send(numbered(0, 5)), BusStatus::ok);
  this->rig.take_down();
  Frame frame;
  for (Bus* end : {a.get(), b.get()})
  {
    EXPECT_EQ(end->send(numbered(1, 1)), BusStatus::down);
    EXPECT_EQ(end->receive(frame), BusStatus::down);
    EXPECT_FALSE(end->recover());
    EXPECT_NE(end->last_error(), "");
  }
  this->rig.bring_up();
  EXPECT_EQ(a->send(numbered(1, 1)), BusStatus::down) << "a gap must not go unnoticed";
  for (Bus* end : {a.get(), b.get()}) EXPECT_TRUE(end->recover()) << end->last_error();
  for (Bus* end : {a.get(), b.get()}) expect_silence(*end);
  expect_connected(*a, *b);
  EXPECT_EQ(a->last_error(), "");
}

TYPED_TEST_P(BusLaws, AnEndOpenedWhileDownComesUp)
{
  this->rig.take_down();
  const auto early = this->rig.open();
  Frame frame;
  EXPECT_EQ(early->receive(frame), BusStatus::down);
  EXPECT_EQ(early->send(numbered(0, 0)), BusStatus::down);
  EXPECT_NE(early->last_error(), "");
  this->rig.bring_up();
  ASSERT_TRUE(early->recover()) << early->last_error();
  const auto late = this->rig.open();
  expect_connected(*early, *late);
}

REGISTER_TYPED_TEST_SUITE_P(BusLaws, EveryOtherEndGetsEveryFrameOnceInOrderAndNoneComesBack, AnEmptyBusDoesNotBlock,
                            EndsComeAndGo, AnErrorFrameReachesTheOthersAsOne, WhatIsNoFrameIsNotSent,
                            AnEndThatDoesNotReadDoesNotDelayTheOthers, DownStaysDownUntilItRecoversAndOldFramesAreGone,
                            AnEndOpenedWhileDownComesUp);

}  // namespace fourwis::can
