#include "fourwis_navigation/can/protocol/cia301.h"

#include <vector>

#include <gtest/gtest.h>

#include "../../support/fuzz_rounds.h"
#include "frame_bytes.h"

namespace fourwis::can
{
namespace
{

TEST(Cia301, MessagesAreTheBytesOfTheStandard)
{
  EXPECT_EQ(encode_nmt(NmtCommand::start, 0), frame_of(0x000, {0x01, 0x00}));
  EXPECT_EQ(encode_nmt(NmtCommand::stop, 3), frame_of(0x000, {0x02, 0x03}));
  EXPECT_EQ(encode_nmt(NmtCommand::enter_pre_operational, 1), frame_of(0x000, {0x80, 0x01}));
  EXPECT_EQ(encode_nmt(NmtCommand::reset_node, 127), frame_of(0x000, {0x81, 0x7F}));
  EXPECT_EQ(encode_nmt(NmtCommand::reset_communication, 8), frame_of(0x000, {0x82, 0x08}));
  EXPECT_EQ(encode_sync(), frame_of(0x080, {}));
  EXPECT_EQ(encode_heartbeat(127, NmtState::operational), frame_of(0x77F, {0x05}));
}

TEST(Cia301, IdentifiersAreThoseOfTheStandard)
{
  const std::vector<std::pair<Service, std::uint32_t>> bases = {
      {Service::emergency, 0x080},   {Service::tpdo1, 0x180},     {Service::tpdo2, 0x280},
      {Service::tpdo3, 0x380},       {Service::tpdo4, 0x480},     {Service::rpdo1, 0x200},
      {Service::rpdo2, 0x300},       {Service::rpdo3, 0x400},     {Service::rpdo4, 0x500},
      {Service::sdo_request, 0x600}, {Service::sdo_reply, 0x580}, {Service::heartbeat, 0x700}};
  for (const auto& [service, base] : bases)
    for (int node = 1; node <= 127; ++node)
    {
      EXPECT_EQ(cob_id(service, node), base + static_cast<std::uint32_t>(node));
      const Address address = address_of(frame_of(base + static_cast<std::uint32_t>(node), {}));
      EXPECT_EQ(address.service, service);
      EXPECT_EQ(address.node, node);
    }
  EXPECT_EQ(address_of(frame_of(0x000, {})).service, Service::nmt);
  EXPECT_EQ(address_of(frame_of(0x080, {})).service, Service::sync);
}

TEST(Cia301, EveryIdentifierIsOneMessageOrNone)
{
  int known = 0;
  for (std::uint32_t id = 0; id <= 0x7FF; ++id)
  {
    const Address address = address_of(frame_of(id, {}));
    if (address.service == Service::other) continue;
    ++known;
    EXPECT_EQ(cob_id(address.service, address.node), id);
  }
  EXPECT_EQ(known, 2 + 12 * 127);
}

TEST(Cia301, OnlyStandardDataFramesCount)
{
  for (bool Frame::*flag : {&Frame::extended, &Frame::remote, &Frame::error})
  {
    Frame frame = frame_of(0x705, {0x05});
    frame.*flag = true;
    EXPECT_EQ(address_of(frame).service, Service::other);
    EXPECT_FALSE(decode_heartbeat(frame));
  }
}

TEST(Cia301, HeartbeatsThereAndBackAreTheSame)
{
  for (const NmtState state : {NmtState::boot_up, NmtState::stopped, NmtState::operational, NmtState::pre_operational})
    EXPECT_EQ(decode_heartbeat(encode_heartbeat(5, state)), state);
  EXPECT_FALSE(decode_heartbeat(frame_of(0x705, {0x06})));
  EXPECT_FALSE(decode_heartbeat(frame_of(0x705, {})));
  EXPECT_FALSE(decode_heartbeat(frame_of(0x705, {0x05, 0x00})));
}

TEST(Cia301, EmergenciesAreReadByteByByte)
{
  const auto emergency = decode_emergency(frame_of(0x083, {0x10, 0x23, 0x81, 1, 2, 3, 4, 5}));
  ASSERT_TRUE(emergency);
  EXPECT_EQ(emergency->code, 0x2310);
  EXPECT_EQ(emergency->error_register, 0x81);
  EXPECT_EQ(emergency->vendor, (std::array<std::uint8_t, 5>{1, 2, 3, 4, 5}));
  EXPECT_FALSE(decode_emergency(frame_of(0x083, {0x10, 0x23, 0x81})));
  EXPECT_FALSE(decode_emergency(frame_of(0x080, {0x10, 0x23, 0x81, 1, 2, 3, 4, 5})));
}

TEST(Cia301, DecodersTakeNothingButTheirOwnMessages)
{
  Random random(2);
  int heartbeats = 0, emergencies = 0;
  for (int i = 0; i < fuzz_rounds(200000); ++i)
  {
    const Frame frame = i % 2 ? random_frame(random) : random_frame(random, random.chance(0.5) ? 0x701 : 0x081);
    const auto heartbeat = decode_heartbeat(frame);
    const auto emergency = decode_emergency(frame);
    if (heartbeat)
    {
      ++heartbeats;
      EXPECT_EQ(encode_heartbeat(static_cast<int>(frame.id & 0x7F), *heartbeat), frame);
    }
    if (emergency)
    {
      ++emergencies;
      EXPECT_TRUE(is_standard(frame) && frame.size == 8 && frame.id > 0x80 && frame.id <= 0xFF);
    }
  }
  EXPECT_GT(heartbeats, 0);
  EXPECT_GT(emergencies, 0);
}

}  // namespace
}  // namespace fourwis::can
