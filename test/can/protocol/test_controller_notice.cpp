#include "fourwis_navigation/can/protocol/controller_notice.h"

#include <gtest/gtest.h>

#include "../../support/fuzz_rounds.h"
#include "frame_bytes.h"

namespace fourwis::can
{
namespace
{

TEST(ControllerNotice, BusOffAndRestartAreClassesOfTheirOwn)
{
  const auto off = decode_notice(error_frame(0x040, {0, 0, 0, 0, 0, 0, 0, 0}));
  ASSERT_TRUE(off);
  EXPECT_TRUE(off->bus_off);
  EXPECT_FALSE(off->restarted || off->passive || off->warning || off->transmit_timeout);
  EXPECT_TRUE(decode_notice(error_frame(0x100, {}))->restarted);
  EXPECT_TRUE(decode_notice(error_frame(0x001, {}))->transmit_timeout);
  EXPECT_TRUE(decode_notice(error_frame(0x020, {}))->no_acknowledge);
}

TEST(ControllerNotice, TheControllersStateIsInTheSecondByteOfItsClassOnly)
{
  const auto passive = decode_notice(error_frame(0x004, {0, 0x20, 0, 0, 0, 0, 130, 7}));
  ASSERT_TRUE(passive);
  EXPECT_TRUE(passive->passive);
  EXPECT_FALSE(passive->warning || passive->bus_off || passive->active);
  EXPECT_EQ(passive->transmit_errors, 130);
  EXPECT_EQ(passive->receive_errors, 7);
  EXPECT_TRUE(decode_notice(error_frame(0x004, {0, 0x01}))->receive_overflow);
  EXPECT_TRUE(decode_notice(error_frame(0x004, {0, 0x02}))->transmit_overflow);
  EXPECT_TRUE(decode_notice(error_frame(0x004, {0, 0x04}))->warning);
  EXPECT_TRUE(decode_notice(error_frame(0x004, {0, 0x08}))->warning);
  EXPECT_TRUE(decode_notice(error_frame(0x004, {0, 0x40}))->active);
  EXPECT_FALSE(decode_notice(error_frame(0x008, {0, 0x20}))->passive);
  EXPECT_FALSE(decode_notice(error_frame(0x004, {}))->passive);
}

TEST(ControllerNotice, FramesOfTheBusAreNone)
{
  Random random(9);
  for (int i = 0; i < fuzz_rounds(100000); ++i)
  {
    const Frame frame = random_frame(random);
    EXPECT_EQ(decode_notice(frame).has_value(), frame.error);
  }
}

}  // namespace
}  // namespace fourwis::can
