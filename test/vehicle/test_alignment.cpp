#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "../support/random.h"
#include "../support/sentences.h"
#include "fourwis_navigation/vehicle/alignment.h"
#include "fourwis_navigation/vehicle/mode_traits.h"
#include "fourwis_navigation/vehicle/wheel_branches.h"

namespace fourwis
{
namespace
{

constexpr double kDegree = M_PI / 180.0;

Robot with_travel(double degrees)
{
  Robot robot;
  robot.wheel_max_angle = degrees * kDegree;
  return robot;
}

std::string rejection(const Robot& robot, double timeout, double besides = 0.0)
{
  return error_of<std::invalid_argument>(
      [&] { check_alignment_timeout(robot, "alignment_timeout", timeout, besides); });
}

/// The inner wheel of the paper's robot is at 46.0 deg at full lock: atan2(L/2, L / (2 tan 30 deg) - W/2). Only one of its
/// branches has all of the steering within the travel.
TEST(Alignment, the_farthest_turn_is_from_an_end_of_the_travel_to_full_lock)
{
  const double inner = std::atan2(0.34, 0.34 / std::tan(30 * kDegree) - 0.26);
  EXPECT_NEAR(farthest_turn(Robot{}), 160 * kDegree + inner, 1e-9);
}

TEST(Alignment, wheels_with_little_travel_turn_through_all_of_it)
{
  EXPECT_NEAR(farthest_turn(with_travel(60)), 120 * kDegree, 1e-9);
  EXPECT_NEAR(farthest_turn(with_travel(100)), 200 * kDegree, 1e-9) << "lateral motion at full lock is beyond it";
}

/// Where every mode has several branches, the next one is never far.
TEST(Alignment, wheels_with_much_travel_turn_by_half_a_turn_and_their_steering)
{
  EXPECT_LE(farthest_turn(with_travel(570)), 180 * kDegree + 2 * 46.1 * kDegree);
  EXPECT_GE(farthest_turn(with_travel(570)), 180 * kDegree - 1e-9);
}

/// Brute force: what choose_branches() asks of wheels anywhere, for any stretch.
TEST(Alignment, no_wheel_is_told_to_turn_farther)
{
  Random random(5);
  for (int k = 0; k < 5000; ++k)
  {
    Robot robot = with_travel(random.between(20.0, 400.0));
    robot.wheelbase = random.between(0.1, 0.9);
    robot.track_width = random.between(0.1, 0.6);
    robot.max_steering_angle = random.between(5.0, 80.0) * kDegree;
    for (const Mode mode : {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin})
    {
      const double limit = max_phi(robot, mode);
      double low = random.between(-limit, limit), high = random.between(low, limit);
      const double start = random.between(low, high);
      if (mode == Mode::parallel) low = high = start;
      PerWheel measured;
      for (double& angle : measured) angle = random.between(-robot.wheel_max_angle, robot.wheel_max_angle);
      const BranchedMotion chosen = choose_branches(robot, {mode, start, low, high}, measured);
      if (chosen.beyond) continue;
      ASSERT_LE(greatest_gap(chosen.motion.angle, measured), farthest_turn(robot) + 1e-6)
          << to_string(mode) << " from " << start << " in " << low << " to " << high << ", travel "
          << robot.wheel_max_angle;
    }
  }
}

TEST(Alignment, a_timeout_that_is_too_short_is_rejected_with_both_keys_and_what_is_enough)
{
  Robot slow;
  slow.wheel_max_rate = 0.4;
  const std::string text = rejection(slow, 5.0, 0.1);
  EXPECT_TRUE(says(text, "'alignment_timeout' is 5, expected at least 9.09 s")) << text;
  EXPECT_TRUE(says(text, "'wheel_max_rate' is 0.4 rad/s")) << text;
  EXPECT_EQ(rejection(slow, 9.09, 0.1), "");
  EXPECT_EQ(rejection(Robot{}, 3.0), "");
}

}  // namespace
}  // namespace fourwis
