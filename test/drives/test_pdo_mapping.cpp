#include <gtest/gtest.h>

#include "drive_bench.h"

namespace fourwis::drives
{
namespace
{

class PdoMapping : public ::testing::Test
{
protected:
  void SetUp() override { bench.boot(); }

  void take_away(int parameters, std::uint32_t cob)
  {
    ASSERT_EQ(bench.write(static_cast<std::uint16_t>(parameters), 1, 4, cob | 0x80000000), 0u);
  }
  /// Disables the PDO, changes its mapping and its transmission type, and enables it again.
  void map(int parameters, int mapping, std::uint32_t cob, int type, std::initializer_list<std::uint32_t> entries)
  {
    take_away(parameters, cob);
    const auto index = static_cast<std::uint16_t>(mapping);
    ASSERT_EQ(bench.write(index, 0, 1, 0), 0u);
    int sub = 0;
    for (std::uint32_t entry : entries) ASSERT_EQ(bench.write(index, ++sub, 4, entry), 0u) << std::hex << entry;
    ASSERT_EQ(bench.write(index, 0, 1, sub), 0u);
    ASSERT_EQ(bench.write(static_cast<std::uint16_t>(parameters), 2, 1, type), 0u);
    ASSERT_EQ(bench.write(static_cast<std::uint16_t>(parameters), 1, 4, cob), 0u);
  }

  DriveBench bench;
};

TEST_F(PdoMapping, IsRefusedWhileThePdoExists)
{
  EXPECT_EQ(bench.write(0x1600, 0, 1, 0), 0x06010000u);
  EXPECT_EQ(bench.write(0x1A00, 1, 4, 0x60410010), 0x06010000u);
  EXPECT_EQ(bench.write(0x1400, 1, 4, 0x206), 0x06090030u);
}

TEST_F(PdoMapping, IsRefusedWhileObjectsAreCounted)
{
  take_away(0x1400, 0x205);
  EXPECT_EQ(bench.write(0x1600, 2, 4, 0x60600008), 0x06010000u);
  ASSERT_EQ(bench.write(0x1600, 0, 1, 0), 0u);
  EXPECT_EQ(bench.write(0x1600, 2, 4, 0x60600008), 0u);
}

TEST_F(PdoMapping, RefusesWhatCannotBeMapped)
{
  take_away(0x1400, 0x205);
  take_away(0x1800, 0x185);
  ASSERT_EQ(bench.write(0x1600, 0, 1, 0), 0u);
  ASSERT_EQ(bench.write(0x1A00, 0, 1, 0), 0u);
  EXPECT_EQ(bench.write(0x1600, 1, 4, 0x12340010), 0x06020000u);  // no such object
  EXPECT_EQ(bench.write(0x1600, 1, 4, 0x60410010), 0x06040041u);  // a status is not received
  EXPECT_EQ(bench.write(0x1600, 1, 4, 0x60400020), 0x06040041u);  // it has 16 bits
  EXPECT_EQ(bench.write(0x1600, 1, 4, 0x10170010), 0x06040041u);  // a setting
  EXPECT_EQ(bench.write(0x1A00, 1, 4, 0x60400010), 0x06040041u);  // a command is not sent
}

TEST_F(PdoMapping, RefusesMoreThanEightBytes)
{
  take_away(0x1A00 - 0x200, 0x185);
  ASSERT_EQ(bench.write(0x1A00, 0, 1, 0), 0u);
  ASSERT_EQ(bench.write(0x1A00, 1, 4, 0x60640020), 0u);
  ASSERT_EQ(bench.write(0x1A00, 2, 4, 0x606C0020), 0u);
  ASSERT_EQ(bench.write(0x1A00, 3, 4, 0x60610008), 0u);
  EXPECT_EQ(bench.write(0x1A00, 0, 1, 3), 0x06040042u);
  EXPECT_EQ(bench.write(0x1A00, 0, 1, 2), 0u);
  EXPECT_EQ(bench.write(0x1A00, 0, 1, 9), 0x06090031u);
}

TEST_F(PdoMapping, RefusesCobIdsOfOtherServicesAndOfTheWrongFormat)
{
  take_away(0x1401, 0x305);
  EXPECT_EQ(bench.write(0x1401, 1, 4, 0x605), 0x06090030u);
  EXPECT_EQ(bench.write(0x1401, 1, 4, 0x705), 0x06090030u);
  EXPECT_EQ(bench.write(0x1401, 1, 4, 0x20000305), 0x06090030u);
  EXPECT_EQ(bench.write(0x1401, 2, 1, 252), 0x06090030u);
}

TEST_F(PdoMapping, TakesEffectWithSync)
{
  map(0x1400, 0x1600, 0x205, 1, {0x60400010, 0x60600008, 0x60FF0020});
  map(0x1800, 0x1A00, 0x185, 1, {0x60410010, 0x60610008});
  map(0x1801, 0x1A01, 0x285, 1, {0x60640020, 0x606C0020});
  bench.start();
  bench.pass(0.05);
  EXPECT_EQ(count_of(bench.sent, 0x185), 0);

  EXPECT_EQ(bench.send(raw(0x205, {0x06, 0x00, 0x09, 0x10, 0x27, 0x00, 0x00})), Frames());
  EXPECT_EQ(bench.read(0x60FF), 0u) << "not before SYNC";
  const Frames before = bench.send(raw(0x080, {}));
  EXPECT_EQ(before, (Frames{raw(0x185, {0x50, 0x02, 0x00}), raw(0x285, {0, 0, 0, 0, 0, 0, 0, 0})}));
  EXPECT_EQ(bench.read(0x60FF), 10000u);
  const Frames after = bench.send(raw(0x080, {}));
  EXPECT_EQ(after, (Frames{raw(0x185, {0x31, 0x02, 0x09}), raw(0x285, {0, 0, 0, 0, 0, 0, 0, 0})}));
}

TEST_F(PdoMapping, EventDrivenGoesAtOnceAndOnChangeOnly)
{
  bench.start();
  bench.pass(0.05);
  EXPECT_EQ(count_of(bench.sent, 0x185), 1) << "when it becomes operational";
  bench.send(raw(0x205, {0x06, 0x00}));
  bench.pass(0.05);
  EXPECT_EQ(count_of(bench.sent, 0x185), 2);
  EXPECT_TRUE(contains(bench.sent, raw(0x185, {0x31, 0x02})));
}

TEST_F(PdoMapping, EventTimerAndInhibitTimeAreKept)
{
  take_away(0x1800, 0x185);
  ASSERT_EQ(bench.write(0x1800, 3, 2, 100), 0u);  // 10 ms
  ASSERT_EQ(bench.write(0x1800, 5, 2, 50), 0u);   // 50 ms
  ASSERT_EQ(bench.write(0x1800, 1, 4, 0x185), 0u);
  bench.start();
  bench.pass(0.201);
  EXPECT_EQ(count_of(bench.sent, 0x185), 5) << "at 0, 50, 100, 150, 200 ms";
  bench.sent.clear();
  for (int k = 0; k < 30; ++k)
  {
    bench.send(raw(0x205, {k % 2 == 0 ? 0x06 : 0x00, 0x00}));
    bench.step();
  }
  EXPECT_LE(count_of(bench.sent, 0x185), 4);
}

TEST_F(PdoMapping, EveryNthSync)
{
  map(0x1800, 0x1A00, 0x185, 3, {0x60410010});
  bench.start();
  int sent = 0;
  for (int k = 0; k < 12; ++k) sent += static_cast<int>(bench.send(raw(0x080, {})).size());
  EXPECT_EQ(sent, 4);
}

TEST_F(PdoMapping, TooShortIsAnErrorTooLongIsNot)
{
  bench.start();
  EXPECT_EQ(bench.send(raw(0x205, {0x06})), Frames{raw(0x085, {0x10, 0x82, 0x11, 0, 0, 0, 0, 0})});
  EXPECT_EQ(bench.state(), 0x40);
  bench.send(raw(0x205, {0x06, 0x00, 0x55}));
  EXPECT_EQ(bench.state(), 0x21);
}

TEST_F(PdoMapping, ProcessDataNeedsOperational)
{
  bench.send(raw(0x205, {0x06, 0x00}));
  EXPECT_EQ(bench.state(), 0x40);
  bench.start();
  bench.send(raw(0x205, {0x06, 0x00}));
  EXPECT_EQ(bench.state(), 0x21);
}

}  // namespace
}  // namespace fourwis::drives
