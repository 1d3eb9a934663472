#include "fourwis_navigation/can/protocol/ranger.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "../../support/fuzz_rounds.h"
#include "frame_bytes.h"

namespace fourwis::can
{
namespace
{

TEST(Ranger, CommandsAreTheBytesOfTheProtocol)
{
  EXPECT_EQ(encode_ranger_motion({1.0, -0.5, 0.3, -0.002}),
            frame_of(0x111, {0x03, 0xE8, 0xFE, 0x0C, 0x01, 0x2C, 0xFF, 0xFE}));
  EXPECT_EQ(encode_ranger_can_control(), frame_of(0x421, {1}));
  EXPECT_EQ(encode_ranger_mode(RangerMode::side_slip), frame_of(0x141, {4}));
  EXPECT_EQ(encode_ranger_mode(RangerMode::dual_ackermann), frame_of(0x141, {0}));
  EXPECT_EQ(encode_ranger_clear_errors(), frame_of(0x441, {0}));
}

TEST(Ranger, WhatDoesNotFitStopsAtTheEndOfItsRange)
{
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(encode_ranger_motion({inf, -inf, std::nan(""), 40.0}),
            frame_of(0x111, {0x7F, 0xFF, 0x80, 0x00, 0x00, 0x00, 0x7F, 0xFF}));
}

TEST(Ranger, FeedbackIsReadByteByByte)
{
  const auto state = decode_ranger_state(frame_of(0x211, {2, 1, 0x01, 0xE0, 0x12, 0x34, 0, 0}));
  ASSERT_TRUE(state);
  EXPECT_EQ(state->vehicle, 2);
  EXPECT_EQ(state->control, 1);
  EXPECT_DOUBLE_EQ(state->voltage, 48.0);
  EXPECT_EQ(state->errors, 0x1234);

  const auto angles = decode_ranger_angles(frame_of(0x271, {0x03, 0xE8, 0xFC, 0x18, 0, 1, 0xFF, 0xFF}));
  ASSERT_TRUE(angles);
  EXPECT_EQ(*angles, (PerWheel{1.0, -1.0, 0.001, -0.001}));
  const auto speeds = decode_ranger_speeds(frame_of(0x281, {0, 0, 0x7F, 0xFF, 0x80, 0, 0, 5}));
  ASSERT_TRUE(speeds);
  EXPECT_EQ(*speeds, (PerWheel{0.0, 32.767, -32.768, 0.005}));

  const auto mode = decode_ranger_mode(frame_of(0x291, {4, 1, 0, 0, 0, 0, 0, 0}));
  ASSERT_TRUE(mode);
  EXPECT_EQ(mode->mode, 4);
  EXPECT_TRUE(mode->changing);
}

TEST(Ranger, MotionThereAndBackIsTheSame)
{
  Random random(7);
  const auto thousandths = [&] { return random.whole(-32768, 32767) / 1000.0; };
  for (int i = 0; i < 20000; ++i)
  {
    const RangerMotion motion{thousandths(), thousandths(), thousandths(), thousandths()};
    Frame frame = encode_ranger_motion(motion);
    frame.id = 0x221;  // command and feedback have the same form
    const auto back = decode_ranger_motion(frame);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->speed, motion.speed, 1e-12);
    EXPECT_NEAR(back->yaw, motion.yaw, 1e-12);
    EXPECT_NEAR(back->lateral, motion.lateral, 1e-12);
    EXPECT_NEAR(back->steering, motion.steering, 1e-12);
  }
}

TEST(Ranger, DecodersTakeNothingButTheirOwnMessages)
{
  Random random(8);
  int taken = 0;
  for (int i = 0; i < fuzz_rounds(200000); ++i)
  {
    const std::uint32_t ids[] = {0x211, 0x221, 0x271, 0x281, 0x291};
    const Frame frame = i % 2 ? random_frame(random) : random_frame(random, ids[random.whole(0, 4)]);
    const auto expect = [&](bool decoded, std::uint32_t id) {
      EXPECT_EQ(decoded, is_standard(frame) && frame.size == 8 && frame.id == id);
      taken += decoded;
    };
    expect(decode_ranger_state(frame).has_value(), 0x211);
    expect(decode_ranger_motion(frame).has_value(), 0x221);
    expect(decode_ranger_angles(frame).has_value(), 0x271);
    expect(decode_ranger_speeds(frame).has_value(), 0x281);
    expect(decode_ranger_mode(frame).has_value(), 0x291);
  }
  EXPECT_GT(taken, 0);
}

}  // namespace
}  // namespace fourwis::can
