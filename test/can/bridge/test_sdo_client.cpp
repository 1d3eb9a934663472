#include "can/bridge/sdo_client.h"

#include <gtest/gtest.h>

#include "../protocol/frame_bytes.h"

namespace fourwis::can
{
namespace
{

using State = SdoClient::State;

constexpr double kTimeout = 0.1;

SdoStep step_of(SdoStep::Kind kind, std::uint16_t index, std::uint32_t value, int size)
{
  SdoStep step;
  step.kind = kind;
  step.object = {index, 0};
  step.value = value;
  step.size = size;
  return step;
}

const Frame kRead1000 = frame_of(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0});
const Frame kWrite6083 = frame_of(0x605, {0x2B, 0x83, 0x60, 0, 0x34, 0x12, 0, 0});
const Frame kRead6083 = frame_of(0x605, {0x40, 0x83, 0x60, 0, 0, 0, 0, 0});
const Frame kIs1000 = frame_of(0x585, {0x43, 0x00, 0x10, 0, 7, 0, 0, 0});
const Frame kWritten6083 = frame_of(0x585, {0x60, 0x83, 0x60, 0, 0, 0, 0, 0});
const Frame kIs6083 = frame_of(0x585, {0x4B, 0x83, 0x60, 0, 0x34, 0x12, 0, 0});

/// A client of node 5: object 1000 must read 7, object 6083 is set to 0x1234.
class Client : public testing::Test
{
protected:
  Client() { client_.start(script_, now_, outbox_); }

  /// The frame that was sent since the last call; an empty one if there is none.
  Frame said()
  {
    EXPECT_LE(outbox_.size(), 1u);
    const Frame frame = outbox_.empty() ? Frame() : outbox_[0];
    outbox_.clear();
    return frame;
  }
  /// The frame that is sent after the timeout; before it none is sent.
  Frame said_after_timeout()
  {
    client_.supervise(now_ + 0.99 * kTimeout, outbox_);
    EXPECT_TRUE(outbox_.empty());
    now_ += 1.01 * kTimeout;
    client_.supervise(now_, outbox_);
    return said();
  }
  void answer(const Frame& frame) { client_.receive(frame, now_, outbox_); }

  SdoScript script_ = {step_of(SdoStep::Kind::expect_equal, 0x1000, 7, 4),
                       step_of(SdoStep::Kind::write, 0x6083, 0x1234, 2)};
  Outbox outbox_;
  SdoClient client_{5, kTimeout};
  double now_ = 3.0;
};

TEST_F(Client, AsksThreeTimesAndNoMore)
{
  EXPECT_EQ(said(), kRead1000);
  EXPECT_EQ(said_after_timeout(), kRead1000);
  EXPECT_EQ(said_after_timeout(), kRead1000);
  EXPECT_EQ(client_.state(), State::working);
  EXPECT_EQ(said_after_timeout(), Frame());
  EXPECT_EQ(client_.state(), State::failed);
  EXPECT_EQ(client_.fault(), Fault::sdo_timeout);
  EXPECT_EQ(client_.object(), 0x100000u);
}

TEST_F(Client, EachRequestHasItsThreeAttempts)
{
  said();
  for (const auto& [request, answer_to_it] :
       {std::pair(kRead1000, kIs1000), {kWrite6083, kWritten6083}, {kRead6083, kIs6083}})
  {
    EXPECT_EQ(said_after_timeout(), request);
    EXPECT_EQ(said_after_timeout(), request);
    EXPECT_EQ(client_.state(), State::working);
    answer(answer_to_it);
    said();
  }
  EXPECT_EQ(client_.state(), State::done);
}

TEST_F(Client, WritesAndReadsBack)
{
  EXPECT_EQ(said(), kRead1000);
  answer(kIs1000);
  EXPECT_EQ(said(), kWrite6083);
  answer(kWritten6083);
  EXPECT_EQ(said(), kRead6083);
  answer(kIs6083);
  EXPECT_EQ(said(), Frame());
  EXPECT_EQ(client_.state(), State::done);
}

/// They may come late, when their request has already been answered.
TEST_F(Client, AnswersToOtherRequestsDoNotCount)
{
  said();
  for (const Frame& other : {kWritten6083, kIs6083, frame_of(0x585, {0x60, 0x00, 0x10, 0, 0, 0, 0, 0})})
  {
    answer(other);
    EXPECT_EQ(said(), Frame());
  }
  answer(kIs1000);
  said();
  for (const Frame& other : {kIs1000, kIs6083})
  {
    answer(other);
    EXPECT_EQ(said(), Frame());
  }
  EXPECT_EQ(client_.state(), State::working);
  EXPECT_EQ(said_after_timeout(), kWrite6083);
}

TEST_F(Client, AnotherValueIsARefusalOfItsStep)
{
  script_[0].mismatch = Fault::wrong_device;
  answer(frame_of(0x585, {0x43, 0x00, 0x10, 0, 8, 0, 0, 0}));
  EXPECT_EQ(client_.state(), State::failed);
  EXPECT_EQ(client_.fault(), Fault::wrong_device);
  EXPECT_EQ(client_.detail(), 8u);
}

TEST_F(Client, OnlyTheBytesOfTheObjectAreCompared)
{
  answer(kIs1000);
  answer(kWritten6083);
  answer(frame_of(0x585, {0x43, 0x83, 0x60, 0, 0x34, 0x12, 0xFF, 0xFF}));
  EXPECT_EQ(client_.state(), State::done);
}

TEST_F(Client, AnObjectThatIsMissingIsGoodEnoughWhereItIsOptional)
{
  const Frame missing = frame_of(0x585, {0x80, 0x83, 0x60, 0, 0x00, 0x00, 0x02, 0x06});
  for (const bool optional : {false, true})
  {
    script_[1].optional = optional;
    client_.start(script_, now_, outbox_);
    answer(kIs1000);
    answer(missing);
    EXPECT_EQ(client_.state(), optional ? State::done : State::failed);
  }
  client_.start(script_, now_, outbox_);
  answer(kIs1000);
  answer(frame_of(0x585, {0x80, 0x83, 0x60, 0, 0x30, 0x00, 0x09, 0x06}));
  EXPECT_EQ(client_.fault(), Fault::sdo_abort) << "the object exists and refuses the value";
}

}  // namespace
}  // namespace fourwis::can
