#include "fourwis_navigation/can/protocol/sdo.h"

#include <string>

#include <gtest/gtest.h>

#include "../../support/fuzz_rounds.h"
#include "frame_bytes.h"

namespace fourwis::can
{
namespace
{

TEST(Sdo, RequestsAreTheBytesOfTheStandard)
{
  EXPECT_EQ(encode_sdo_write(1, {0x6060, 0}, 8, 1), frame_of(0x601, {0x2F, 0x60, 0x60, 0, 8, 0, 0, 0}));
  EXPECT_EQ(encode_sdo_write(2, {0x1017, 0}, 50, 2), frame_of(0x602, {0x2B, 0x17, 0x10, 0, 50, 0, 0, 0}));
  EXPECT_EQ(encode_sdo_write(3, {0x1234, 5}, 0xFF010203, 3), frame_of(0x603, {0x27, 0x34, 0x12, 5, 3, 2, 1, 0}));
  EXPECT_EQ(encode_sdo_write(8, {0x1600, 1}, 0x60400010, 4),
            frame_of(0x608, {0x23, 0x00, 0x16, 1, 0x10, 0x00, 0x40, 0x60}));
  EXPECT_EQ(encode_sdo_write(1, {0x6098, 0}, static_cast<std::uint32_t>(-1), 1),
            frame_of(0x601, {0x2F, 0x98, 0x60, 0, 0xFF, 0, 0, 0}));
  EXPECT_EQ(encode_sdo_read(127, {0x1018, 2}), frame_of(0x67F, {0x40, 0x18, 0x10, 2, 0, 0, 0, 0}));
}

/// A known answer and its meaning.
struct Answer
{
  Frame frame;
  SdoReply reply;
};

TEST(Sdo, AnswersAreReadByteByByte)
{
  using Kind = SdoReply::Kind;
  const std::vector<Answer> answers = {
      {frame_of(0x581, {0x60, 0x40, 0x60, 0, 9, 9, 9, 9}), {Kind::written, {0x6040, 0}, 0, 0}},
      {frame_of(0x581, {0x4F, 0x61, 0x60, 0, 8, 9, 9, 9}), {Kind::value, {0x6061, 0}, 8, 1}},
      {frame_of(0x581, {0x4B, 0x41, 0x60, 0, 0x37, 0x12, 9, 9}), {Kind::value, {0x6041, 0}, 0x1237, 2}},
      {frame_of(0x581, {0x47, 0x34, 0x12, 5, 1, 2, 3, 9}), {Kind::value, {0x1234, 5}, 0x030201, 3}},
      {frame_of(0x5FF, {0x43, 0x18, 0x10, 1, 1, 2, 3, 4}), {Kind::value, {0x1018, 1}, 0x04030201, 4}},
      {frame_of(0x581, {0x42, 0x18, 0x10, 1, 1, 2, 3, 4}), {Kind::value, {0x1018, 1}, 0x04030201, 4}},
      {frame_of(0x588, {0x80, 0x00, 0x16, 1, 0x41, 0, 4, 6}), {Kind::abort, {0x1600, 1}, 0x06040041, 4}},
  };
  for (const Answer& expected : answers)
  {
    const auto reply = decode_sdo_reply(expected.frame);
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->kind, expected.reply.kind);
    EXPECT_EQ(reply->object, expected.reply.object);
    EXPECT_EQ(reply->value, expected.reply.value);
    EXPECT_EQ(reply->size, expected.reply.size);
  }
}

TEST(Sdo, SegmentedBlockAndShortAnswersAreRefused)
{
  EXPECT_FALSE(decode_sdo_reply(frame_of(0x581, {0x41, 0x08, 0x10, 0, 20, 0, 0, 0})));  // segmented: the size only
  EXPECT_FALSE(decode_sdo_reply(frame_of(0x581, {0xC2, 0x08, 0x10, 0, 20, 0, 0, 0})));  // block
  EXPECT_FALSE(decode_sdo_reply(frame_of(0x581, {0x00, 1, 2, 3, 4, 5, 6, 7})));         // segment
  EXPECT_FALSE(decode_sdo_reply(frame_of(0x581, {0x60, 0x40, 0x60, 0, 0, 0, 0})));
  EXPECT_FALSE(decode_sdo_reply(frame_of(0x601, {0x60, 0x40, 0x60, 0, 0, 0, 0, 0})));  // a request
}

/// The answer of a node to a read of an object of that size, with an encoder of its own.
Frame answer_to_read(int node, ObjectId object, std::uint32_t value, int size)
{
  static const int commands[] = {0x4F, 0x4B, 0x47, 0x43};
  Frame frame = frame_of(0x580u + static_cast<std::uint32_t>(node),
                         {commands[size - 1], object.index & 0xFF, object.index >> 8, object.sub});
  for (int i = 0; i < 4; ++i) frame.data[frame.size++] = static_cast<std::uint8_t>(i < size ? value >> (8 * i) : 0xAA);
  return frame;
}

TEST(Sdo, ValuesThereAndBackAreTheSame)
{
  Random random(3);
  for (int i = 0; i < 20000; ++i)
  {
    const int size = random.whole(1, 4);
    const auto value = static_cast<std::uint32_t>(random.whole(0, 0x7FFFFFFF)) & (0xFFFFFFFFu >> (8 * (4 - size)));
    const ObjectId object{static_cast<std::uint16_t>(random.whole(0, 0xFFFF)),
                          static_cast<std::uint8_t>(random.whole(0, 255))};
    const auto reply = decode_sdo_reply(answer_to_read(random.whole(1, 127), object, value, size));
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->object, object);
    EXPECT_EQ(reply->value, value);
    EXPECT_EQ(reply->size, size);
  }
}

TEST(Sdo, AnythingElseIsRefused)
{
  Random random(4);
  int taken = 0;
  for (int i = 0; i < fuzz_rounds(200000); ++i)
  {
    const Frame frame = random.chance(0.5) ? random_frame(random) : random_frame(random, 0x581);
    const auto reply = decode_sdo_reply(frame);
    if (!reply) continue;
    ++taken;
    EXPECT_TRUE(is_standard(frame) && frame.size == 8 && frame.id > 0x580 && frame.id < 0x600);
    EXPECT_TRUE(reply->size >= 0 && reply->size <= 4);
  }
  EXPECT_GT(taken, 0);
}

TEST(Sdo, AbortCodesHaveWords)
{
  EXPECT_EQ(std::string(sdo_abort_text(0x06040041)), "the object cannot be mapped");
  EXPECT_EQ(std::string(sdo_abort_text(0x06020000)), "no such object");
  EXPECT_EQ(std::string(sdo_abort_text(1)), "unknown");
}

}  // namespace
}  // namespace fourwis::can
