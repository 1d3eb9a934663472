#include "fourwis_navigation/can/bus/mailbox.h"

#include <array>
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

namespace fourwis::can
{
namespace
{

TEST(Mailbox, GivesTheNewestOnce)
{
  Mailbox<int> mailbox;
  int value = 0;
  EXPECT_FALSE(mailbox.take(value));
  mailbox.put(1);
  mailbox.put(2);
  EXPECT_TRUE(mailbox.take(value));
  EXPECT_EQ(value, 2);
  EXPECT_FALSE(mailbox.take(value));
  mailbox.put(3);
  EXPECT_TRUE(mailbox.take(value));
  EXPECT_EQ(value, 3);
}

TEST(Mailbox, BetweenTwoThreadsNothingIsTornNothingGoesBackAndTheLastArrives)
{
  using Block = std::array<int, 32>;
  constexpr int kLast = 200000;
  Mailbox<Block> mailbox;
  std::thread writer([&] {
    for (int i = 1; i <= kLast; ++i)
    {
      Block block;
      block.fill(i);
      mailbox.put(block);
    }
  });
  int last = 0;
  for (Block block{}; last < kLast;)
  {
    if (!mailbox.take(block)) continue;
    for (const int value : block) ASSERT_EQ(value, block.front());
    ASSERT_GT(block.front(), last);
    last = block.front();
  }
  writer.join();
}

}  // namespace
}  // namespace fourwis::can
