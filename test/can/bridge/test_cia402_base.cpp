#include "can/bridge/cia402_base.h"

#include <gtest/gtest.h>

#include "../protocol/frame_bytes.h"

namespace fourwis::can
{
namespace
{

/// The master of nodes 1 to 8, which has been started and has received nothing.
class Base : public testing::Test
{
protected:
  Base() { base_.restart(false, 0.0, outbox_); }

  /// Receives this frame, and nothing else for a second.
  void listen_to(const Frame& frame)
  {
    base_.receive(frame, 0.01, outbox_);
    for (int cycle = 1; cycle <= 100; ++cycle) base_.supervise(0.01 * cycle, outbox_);
  }

  FaultLog log_;
  Outbox outbox_;
  Cia402Base base_{Robot(), BridgeOptions(), log_};
};

/// Messages that only the master of nodes 1 to 8 sends; its own node id is 127.
const std::vector<Frame> kMasters = {
    frame_of(0x000, {1, 0}),
    frame_of(0x000, {1, 99}),
    frame_of(0x080, {}),
    frame_of(0x77F, {5}),
    frame_of(0x201, {0x0F, 0, 8, 0, 0, 0, 0}),
    frame_of(0x308, {0x0F, 0, 9, 0, 0, 0, 0}),
    frame_of(0x401, {0}),
    frame_of(0x508, {0}),
    frame_of(0x601, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}),
    frame_of(0x608, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}),
};

/// Messages of other nodes, and messages to nodes that are not ours.
const std::vector<Frame> kOthers = {
    frame_of(0x701, {5}),
    frame_of(0x77E, {5}),
    frame_of(0x709, {0}),
    frame_of(0x081, {0, 0, 0, 0, 0, 0, 0, 0}),
    frame_of(0x181, {0x37, 0x02, 8}),
    frame_of(0x581, {0x60, 0x40, 0x60, 0, 0, 0, 0, 0}),
    frame_of(0x209, {0x0F, 0, 8, 0, 0, 0, 0}),
    frame_of(0x609, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}),
};

TEST_F(Base, StaysSilentWhereAnotherMasterSpeaks)
{
  for (const Frame& frame : kMasters)
  {
    SCOPED_TRACE(frame.id);
    log_.clear();
    base_.restart(false, 0.0, outbox_);
    listen_to(frame);
    EXPECT_EQ(log_.cause().fault, Fault::foreign_master);
    EXPECT_EQ(log_.cause().detail, frame.id);
    EXPECT_EQ(base_.step(), StartStep::listening);
    EXPECT_TRUE(outbox_.empty());
  }
}

TEST_F(Base, StartsWhenOnlyOtherMessagesCome)
{
  for (const Frame& frame : kOthers) listen_to(frame);
  EXPECT_FALSE(log_.cause().exists()) << text_of(log_.cause());
  EXPECT_EQ(base_.step(), StartStep::booting);
  EXPECT_FALSE(outbox_.empty());
}

TEST_F(Base, NoticesAnotherMasterLaterAsWell)
{
  listen_to(frame_of(0x701, {5}));
  ASSERT_EQ(base_.step(), StartStep::booting);
  for (const Frame& frame : kMasters)
  {
    SCOPED_TRACE(frame.id);
    log_.clear();
    base_.receive(frame, 2.0, outbox_);
    EXPECT_EQ(log_.cause().fault, Fault::foreign_master);
  }
  log_.clear();
  for (const Frame& frame : kOthers) base_.receive(frame, 2.0, outbox_);
  EXPECT_NE(log_.cause().fault, Fault::foreign_master);
}

}  // namespace
}  // namespace fourwis::can
