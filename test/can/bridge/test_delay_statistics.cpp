#include "fourwis_navigation/can/bridge/delay_statistics.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "../../support/random.h"

namespace fourwis::can
{
namespace
{

TEST(DelayStatistics, PercentilesAreThoseOfTheSortedDelaysRoundedUpToABin)
{
  Random random(15);
  DelayStatistics statistics;
  std::vector<double> delays;
  for (int i = 0; i < 5000; ++i)
  {
    delays.push_back(random.chance(0.99) ? random.between(0.0, 0.001) : random.between(0.0, 0.009));
    statistics.add(delays.back());
  }
  std::sort(delays.begin(), delays.end());
  for (const double share : {0.01, 0.5, 0.9, 0.99, 0.999})
  {
    const double exact = delays[static_cast<std::size_t>(share * 5000.0) - 1];
    EXPECT_GE(statistics.percentile(share), exact);
    EXPECT_LE(statistics.percentile(share), exact + 21e-6);
  }
  EXPECT_EQ(statistics.percentile(1.0), delays.back());
  EXPECT_EQ(statistics.longest(), delays.back());
  EXPECT_EQ(statistics.count(), 5000u);
}

TEST(DelayStatistics, OfNothingAreZeroAndVeryLongOnesCount)
{
  DelayStatistics statistics;
  EXPECT_EQ(statistics.percentile(0.99), 0.0);
  statistics.add(2.0);
  EXPECT_EQ(statistics.longest(), 2.0);
  EXPECT_EQ(statistics.count(), 1u);
}

}  // namespace
}  // namespace fourwis::can
