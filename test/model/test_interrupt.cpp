#include "fourwis_navigation/model/interrupt.h"

#include <gtest/gtest.h>

namespace fourwis
{
namespace
{

constexpr double kForEver = 1e12;  ///< longer than the clock can count [s]

TEST(Interrupt, NeverHappensUnlessAskedFor)
{
  EXPECT_FALSE(Interrupt().cancelled());
  EXPECT_FALSE(Interrupt().timed_out());
  EXPECT_FALSE(Interrupt(nullptr).cancelled());
}

TEST(Interrupt, FollowsTheFlagItWatches)
{
  std::atomic<bool> flag{false};
  const Interrupt interrupt(&flag);
  EXPECT_FALSE(interrupt.cancelled());
  flag = true;
  EXPECT_TRUE(interrupt.cancelled());
  EXPECT_TRUE(interrupt.or_after(kForEver).cancelled());
  EXPECT_FALSE(interrupt.timed_out());
}

TEST(Interrupt, TimesOutWhenTheDeadlineHasPassed)
{
  const Interrupt::Clock::time_point now = Interrupt::Clock::now();
  EXPECT_TRUE(Interrupt(nullptr, now).timed_out());
  EXPECT_FALSE(Interrupt(nullptr, now + std::chrono::hours(24)).timed_out());
}

TEST(Interrupt, TakesTheEarlierOfTwoDeadlines)
{
  const Interrupt::Clock::time_point now = Interrupt::Clock::now();
  const Interrupt past(nullptr, now), distant(nullptr, now + std::chrono::hours(24));
  EXPECT_TRUE(past.or_after(3600.0).timed_out());
  EXPECT_TRUE(distant.or_after(0.0).timed_out());
  EXPECT_TRUE(Interrupt().or_after(-1.0).timed_out());
  EXPECT_FALSE(distant.or_after(3600.0).timed_out());
}

TEST(Interrupt, CanWaitForEver)
{
  EXPECT_FALSE(Interrupt().or_after(kForEver).timed_out());
  EXPECT_FALSE(Interrupt().or_after(9e9).timed_out());
}

}  // namespace
}  // namespace fourwis
