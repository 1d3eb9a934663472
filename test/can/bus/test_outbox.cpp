#include "fourwis_navigation/can/bus/outbox.h"

#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "../protocol/frame_bytes.h"
#include "can/bus/memory_bus.h"

namespace fourwis::can
{
namespace
{

std::vector<Frame> received(Bus& bus)
{
  std::vector<Frame> frames;
  for (Frame frame; bus.receive(frame) == BusStatus::ok;) frames.push_back(frame);
  return frames;
}

class OutboxOnABus : public testing::Test
{
protected:
  MemoryBus bus_;
  std::unique_ptr<MemoryBus::End> sender_ = bus_.open(), receiver_ = bus_.open();
  Outbox outbox_;
};

TEST_F(OutboxOnABus, SendsInOrderAndIsEmptyThen)
{
  outbox_.put(frame_of(0x201, {1}));
  outbox_.add(frame_of(0x000, {2}));
  outbox_.put(frame_of(0x080, {}));
  EXPECT_EQ(outbox_.flush(*sender_), BusStatus::ok);
  EXPECT_TRUE(outbox_.empty());
  EXPECT_EQ(outbox_.sent(), 3u);
  EXPECT_EQ(received(*receiver_),
            (std::vector<Frame>{frame_of(0x201, {1}), frame_of(0x000, {2}), frame_of(0x080, {})}));
}

TEST_F(OutboxOnABus, WhatWaitsIsReplacedByTheNewestOfItsIdentifierInItsPlace)
{
  sender_->set_full(true);
  outbox_.put(frame_of(0x201, {1}));
  outbox_.put(frame_of(0x202, {2}));
  EXPECT_EQ(outbox_.flush(*sender_), BusStatus::would_block);
  outbox_.put(frame_of(0x201, {3, 4}));
  EXPECT_EQ(outbox_.replaced(), 1u);
  sender_->set_full(false);
  EXPECT_EQ(outbox_.flush(*sender_), BusStatus::ok);
  EXPECT_EQ(received(*receiver_), (std::vector<Frame>{frame_of(0x201, {3, 4}), frame_of(0x202, {2})}));
}

TEST_F(OutboxOnABus, HoldsBackWhatIsMoreThanItsCapacity)
{
  for (int i = 0; i < 100; ++i) outbox_.add(frame_of(0x000, {1, i}));
  EXPECT_EQ(outbox_.size(), Outbox::kCapacity);
  EXPECT_EQ(outbox_.lost(), 100u - Outbox::kCapacity);
}

TEST_F(OutboxOnABus, OnlyTheNewestFrameOfAnIdentifierIsSent)
{
  Random random(10);
  std::map<std::uint32_t, int> newest;
  for (int i = 0; i < 5000; ++i)
  {
    sender_->set_full(random.chance(0.7));
    const auto id = static_cast<std::uint32_t>(random.whole(0x201, 0x208));
    newest[id] = i;
    outbox_.put(frame_of(id, {i & 0xFF, i >> 8}));
    outbox_.flush(*sender_);
    EXPECT_LE(outbox_.size(), 8u);
    for (const Frame& frame : received(*receiver_)) EXPECT_EQ(frame.data[0] | frame.data[1] << 8, newest[frame.id]);
  }
}

}  // namespace
}  // namespace fourwis::can
