#include "can/bridge/link_watch.h"

#include <gtest/gtest.h>

#include "../protocol/frame_bytes.h"

namespace fourwis::can
{
namespace
{

const Frame kBusOff = error_frame(0x040, {0, 0, 0, 0, 0, 0, 0, 0});
const Frame kPassive = error_frame(0x004, {0, 0x20, 0, 0, 0, 0, 130, 7});
const Frame kProtocolError = error_frame(0x008, {0, 0, 1, 0, 0, 0, 0, 0});

/// An interface that is up.
class Link : public testing::Test
{
protected:
  Link() { watch_.set_up(true, 0.0); }

  /// A second in which no frame leaves the queue.
  void block()
  {
    outbox_.put(frame_of(0x080, {}));
    for (int cycle = 0; cycle < 100; ++cycle) watch_.supervise(outbox_, 0.01 * cycle);
  }

  FaultLog log_;
  Outbox outbox_;
  LinkWatch watch_{BridgeOptions(), log_};
};

TEST_F(Link, WhatTheControllerIsSaidToBeOutlivesErrorsOfSingleFrames)
{
  watch_.receive(kPassive, 1.0);
  watch_.receive(kProtocolError, 2.0);
  EXPECT_TRUE(watch_.notice().passive);
  EXPECT_EQ(watch_.notice().transmit_errors, 130);
  watch_.receive(error_frame(0x004, {0, 0x40, 0, 0, 0, 0, 0, 0}), 3.0);
  EXPECT_FALSE(watch_.notice().passive);
}

TEST_F(Link, IsOnTheBusAgainWithAFrameOrWhenItIsUpAgain)
{
  watch_.receive(kBusOff, 1.0);
  EXPECT_FALSE(watch_.usable());
  watch_.receive(frame_of(0x701, {5}), 2.0);
  EXPECT_TRUE(watch_.usable());
  EXPECT_FALSE(watch_.notice().bus_off);
  watch_.receive(kBusOff, 3.0);
  watch_.set_up(false, 4.0);
  watch_.set_up(true, 5.0);
  EXPECT_TRUE(watch_.usable());
  EXPECT_FALSE(watch_.notice().bus_off);
}

TEST_F(Link, IsNotAtFaultForAQueueBeforeAnyNodeAcknowledges)
{
  block();
  EXPECT_FALSE(log_.cause().fault == Fault::transmit_timeout);
  watch_.receive(frame_of(0x701, {5}), 1.0);
  block();
  EXPECT_TRUE(log_.cause().fault == Fault::transmit_timeout);
}

}  // namespace
}  // namespace fourwis::can
