#include "ros/stamps.h"

#include <limits>

#include <gtest/gtest.h>

namespace fourwis
{
namespace
{

constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();

/// The simulation's lockstep compares with its period and must not be wrong by a bit.
TEST(Stamps, between_control_steps_lies_exactly_their_period)
{
  for (const double period : {0.01, 0.02, 0.05})
  {
    ros::Time step(1000.0);
    for (int k = 0; k < 5000; ++k)
    {
      const ros::Time next = step + ros::Duration(period);
      ASSERT_EQ(seconds_between(step, next), period) << "at " << step;
      ASSERT_EQ(seconds_between(next, step), -period) << "at " << step;
      step = next;
    }
  }
}

TEST(Stamps, any_two_have_a_difference)
{
  EXPECT_EQ(seconds_between(ros::Time(), ros::Time(kMost, 0)), 4294967295.0);
  EXPECT_EQ(seconds_between(ros::Time(kMost, 0), ros::Time()), -4294967295.0);
  EXPECT_EQ(seconds_between(ros::Time(kMost, 999999999), ros::Time(kMost, 999999999)), 0.0);
}

TEST(Stamps, of_what_is_measured_in_order_are_in_order_unless_the_clock_was_set_back)
{
  const ros::Time last(1000.0);
  EXPECT_EQ(in_order(ros::Time(), last), last);
  EXPECT_EQ(in_order(last, last + ros::Duration(0.01)), last + ros::Duration(0.01));
  EXPECT_EQ(in_order(last, last - ros::Duration(0.01)), last + ros::Duration(0, 1));
  EXPECT_EQ(in_order(last, last), last + ros::Duration(0, 1));
  EXPECT_EQ(in_order(last, ros::Time(10.0)), ros::Time(10.0));
}

}  // namespace
}  // namespace fourwis
