#include "search/reeds_shepp.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "reeds_shepp_samples.h"

namespace fourwis
{
namespace
{

constexpr double accuracy = 1e-9;
constexpr unsigned seed = 20250101;

std::vector<Pose> border_poses(int count)
{
  std::vector<Pose> poses = {{0, 0, 0},      {3, 0, 0},     {-3, 0, 0},   {0, 0, M_PI}, {0, 0, -M_PI},
                             {0, 2, M_PI},   {0, 4, 0},     {2, 2, 0},    {4, 0, M_PI}, {0, 1e-16, 0},
                             {1e-300, 0, 0}, {50, 0, M_PI}, {0, 0, 1e-16}};
  for (const ReedsSheppPath& word : border_words(count, seed)) poses.push_back(drive(word));
  return poses;
}

std::vector<Pose> all_poses()
{
  std::vector<Pose> poses = random_poses(20000, seed);
  const std::vector<Pose> borders = border_poses(20000);
  poses.insert(poses.end(), borders.begin(), borders.end());
  return poses;
}

/// A word in the paper's notation.
std::string name(const ReedsSheppPath& path)
{
  std::string name;
  for (std::size_t i = 0; i < path.count; ++i)
  {
    name += "RSL"[path.segments[i].turn + 1];
    name += path.segments[i].length > 0.0 ? '+' : '-';
  }
  return name;
}

struct Laws : testing::Test
{
  testing::ScopedTrace trace{__FILE__, __LINE__, "seed " + std::to_string(seed)};
  ReedsSheppWords words;
};

TEST_F(Laws, EveryWordEndsAtTheGoal)
{
  for (const Pose& goal : all_poses())
  {
    reeds_shepp_words(goal, words);
    for (std::size_t i = 0; i < words.count; ++i)
      ASSERT_LE(error(drive(words.paths[i]), goal), accuracy) << name(words.paths[i]) << " to " << goal;
    ASSERT_LE(error(drive(shortest_reeds_shepp(goal)), goal), accuracy) << goal;
  }
}

TEST_F(Laws, ThereAreOneTo48WordsToEveryGoal)
{
  for (const Pose& goal : all_poses())
  {
    reeds_shepp_words(goal, words);
    ASSERT_GE(words.count, 1u) << goal;
    ASSERT_LE(words.count, 48u) << goal;
  }
}

TEST_F(Laws, TheLengthOfAWordIsThatOfItsSegmentsAndNoArcExceedsHalfATurn)
{
  for (const Pose& goal : all_poses())
  {
    reeds_shepp_words(goal, words);
    for (std::size_t i = 0; i < words.count; ++i)
    {
      double sum = 0.0;
      for (std::size_t k = 0; k < words.paths[i].count; ++k)
      {
        const ReedsSheppSegment& segment = words.paths[i].segments[k];
        ASSERT_NE(segment.length, 0.0) << goal;
        ASSERT_TRUE(segment.turn == 0 || std::abs(segment.length) <= M_PI + 1e-12) << goal;
        sum += std::abs(segment.length);
      }
      ASSERT_NEAR(words.paths[i].length, sum, 1e-12) << goal;
    }
  }
}

TEST_F(Laws, TheShortestWordIsTheLeastOfAll)
{
  for (const Pose& goal : all_poses())
  {
    reeds_shepp_words(goal, words);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < words.count; ++i) least = std::min(least, words.paths[i].length);
    ASSERT_EQ(shortest_reeds_shepp(goal).length, least) << goal;
    ASSERT_EQ(reeds_shepp_length(goal), least) << goal;
  }
}

TEST_F(Laws, EachOfThe48WordsIsTheShortestSomewhere)
{
  std::set<std::string> shortest, found;
  for (const Pose& goal : random_poses(200000, seed))
  {
    shortest.insert(name(shortest_reeds_shepp(goal)));
    reeds_shepp_words(goal, words);
    for (std::size_t i = 0; i < words.count; ++i) found.insert(name(words.paths[i]));
  }
  EXPECT_EQ(shortest.size(), 48u);
  EXPECT_EQ(found, shortest);
}

TEST_F(Laws, TimeFlipAndReflectionOfTheGoalKeepTheLength)
{
  for (const Pose& goal : all_poses())
  {
    const double length = reeds_shepp_length(goal);
    ASSERT_NEAR(reeds_shepp_length({-goal.x, goal.y, -goal.theta}), length, accuracy) << "time-flip " << goal;
    ASSERT_NEAR(reeds_shepp_length({goal.x, -goal.y, -goal.theta}), length, accuracy) << "reflection " << goal;
    ASSERT_NEAR(reeds_shepp_length({-goal.x, -goal.y, goal.theta}), length, accuracy) << "both " << goal;
  }
}

TEST_F(Laws, TimeFlipAndReflectionOfTheGoalKeepTheWords)
{
  const auto mirrored_names = [this](const Pose& goal, int time, int side) {
    reeds_shepp_words(goal, words);
    std::multiset<std::string> names;
    for (std::size_t i = 0; i < words.count; ++i)
    {
      for (ReedsSheppSegment& segment : words.paths[i].segments) segment = {segment.turn * side, segment.length * time};
      names.insert(name(words.paths[i]));
    }
    return names;
  };
  for (const Pose& goal : random_poses(20000, seed))
  {
    const std::multiset<std::string> names = mirrored_names(goal, 1, 1);
    ASSERT_EQ(mirrored_names({-goal.x, goal.y, -goal.theta}, -1, 1), names) << "time-flip " << goal;
    ASSERT_EQ(mirrored_names({goal.x, -goal.y, -goal.theta}, 1, -1), names) << "reflection " << goal;
    ASSERT_EQ(mirrored_names({-goal.x, -goal.y, goal.theta}, -1, -1), names) << "both " << goal;
  }
}

TEST_F(Laws, TheWayBackAndTheWordReadBackwardsAreAsLong)
{
  for (const Pose& goal : random_poses(20000, seed))
  {
    const double length = reeds_shepp_length(goal), c = std::cos(goal.theta), s = std::sin(goal.theta);
    ASSERT_NEAR(reeds_shepp_length(relative_to(goal, Pose{})), length, accuracy) << "way back " << goal;
    ASSERT_NEAR(reeds_shepp_length({goal.x * c + goal.y * s, goal.x * s - goal.y * c, goal.theta}), length, accuracy)
        << "backwards " << goal;
  }
}

TEST_F(Laws, WholeTurnsOfTheGoalChangeNothing)
{
  for (const Pose& goal : random_poses(20000, seed))
    for (const int turns : {-3, -1, 1, 2})
      ASSERT_NEAR(reeds_shepp_length({goal.x, goal.y, goal.theta + 2.0 * M_PI * turns}), reeds_shepp_length(goal), 1e-7)
          << goal;
}

TEST_F(Laws, NoCarIsFasterThanTheCrowOrTurnsFasterThanItsCircle)
{
  for (const Pose& goal : all_poses())
  {
    const double length = reeds_shepp_length(goal);
    ASSERT_GE(length, std::hypot(goal.x, goal.y) - accuracy) << goal;
    ASSERT_GE(length, std::abs(wrap_angle(goal.theta)) - accuracy) << goal;
  }
}

TEST_F(Laws, NoWayThatLeadsToTheGoalIsShorter)
{
  for (const ReedsSheppPath& way : border_words(100000, seed))
    ASSERT_LE(reeds_shepp_length(drive(way)), way.length + accuracy) << name(way) << " to " << drive(way);
}

TEST_F(Laws, ADetourIsNoShortcut)
{
  const std::vector<Pose> poses = random_poses(20000, seed);
  for (std::size_t i = 0; i + 7 < poses.size(); ++i)
  {
    const Pose &first = poses[i], &second = poses[i + 7];
    ASSERT_LE(reeds_shepp_length(compose(first, second)),
              reeds_shepp_length(first) + reeds_shepp_length(second) + accuracy)
        << first << second;
  }
}

TEST_F(Laws, AWiderTurningRadiusMakesNoWayShorter)
{
  for (const Pose& goal : random_poses(20000, seed))
    for (const double radius : {1.001, 1.5, 10.0})
      ASSERT_GE(radius * reeds_shepp_length({goal.x / radius, goal.y / radius, goal.theta}),
                reeds_shepp_length(goal) - accuracy)
          << goal;
}

TEST(ReedsShepp, NeedsNoWayToWhereItIs)
{
  EXPECT_EQ(reeds_shepp_length({}), 0.0);
  EXPECT_EQ(shortest_reeds_shepp({}).count, 0u);
}

TEST(ReedsShepp, DrivesStraightToWhatLiesAhead)
{
  for (const double x : {0.1, 1.0, M_PI, 1000.0, -0.1, -1.0, -M_PI, -1000.0})
  {
    const ReedsSheppPath path = shortest_reeds_shepp({x, 0.0, 0.0});
    ASSERT_EQ(path.count, 1u) << x;
    EXPECT_EQ(path.segments[0].turn, 0) << x;
    EXPECT_NEAR(path.segments[0].length, x, 1e-12);
  }
  for (const double x : {1e-3, 1e-6, 1e-9, 1e-12}) EXPECT_NEAR(reeds_shepp_length({x, 0.0, 0.0}) / x, 1.0, accuracy);
}

TEST(ReedsShepp, DrivesOneArcToWhatLiesOnIt)
{
  for (const int turn : {-1, 1})
    for (const double angle : {-M_PI, -2.0, -M_PI / 2, -1e-3, -1e-8, 1e-8, 1e-3, 0.3, 1.0, M_PI / 2, 3.0, M_PI})
    {
      const Pose goal{std::sin(angle), turn * (1.0 - std::cos(angle)), turn * angle};
      ASSERT_NEAR(reeds_shepp_length(goal), std::abs(angle), accuracy) << goal;
      ASSERT_LE(error(drive(shortest_reeds_shepp(goal)), goal), accuracy) << goal;
    }
}

TEST(ReedsShepp, KnowsTheHalfTurnForwardAndBackward)
{
  // Both lead to the same pose; a planner that prefers forward gear needs the one, independent of the rounding of pi.
  const auto names = [](const Pose& goal) {
    ReedsSheppWords words;
    reeds_shepp_words(goal, words);
    std::set<std::string> found;
    for (std::size_t i = 0; i < words.count; ++i) found.insert(name(words.paths[i]));
    return found;
  };
  for (const double theta : {M_PI, -M_PI})
  {
    EXPECT_TRUE(names({0.0, 2.0, theta}).count("L+") && names({0.0, 2.0, theta}).count("L-")) << theta;
    EXPECT_TRUE(names({-5.0, 2.0, theta}).count("L+S+") && names({-5.0, 2.0, theta}).count("S-L-")) << theta;
    EXPECT_TRUE(names({5.0, 2.0, theta}).count("S+L+") && names({5.0, 2.0, theta}).count("L-S-")) << theta;
    EXPECT_TRUE(names({-5.0, -2.0, theta}).count("R+S+") && names({-5.0, -2.0, theta}).count("S-R-")) << theta;
  }
}

TEST(ReedsShepp, TurnsRoundOnTheSpotInThreeArcsOfSixtyDegrees)
{
  for (const double theta : {M_PI, -M_PI, 3.0 * M_PI})
  {
    const ReedsSheppPath path = shortest_reeds_shepp({0.0, 0.0, theta});
    ASSERT_EQ(path.count, 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(std::abs(path.segments[i].length), M_PI / 3.0, accuracy);
  }
}

TEST(ReedsShepp, KeepsTheShortestWordToGoalsBesideALine)
{
  // A straight, then a hint of an arc: rounding alone decides whether the first arc of L+ S+ L+ is negative.
  for (const double straight : {1e-3, 0.0596570834858, 0.7, 30.0})
    for (const double arc : {1e-6, 1e-8, 1e-10, 1e-12, 1e-14})
    {
      const Pose goal{straight + std::sin(arc), 2.0 * std::pow(std::sin(arc / 2.0), 2), arc};
      EXPECT_NEAR(reeds_shepp_length(goal), straight + arc, accuracy) << goal;
    }
}

TEST(ReedsShepp, ATinyOffsetSidewaysTakesFourEqualArcs)
{
  // In the limit four arcs of angle a move aside by 2 a^2.
  for (const double y : {1e-5, 1e-7, 1e-9, -1e-9})
    EXPECT_NEAR(reeds_shepp_length({0.0, y, 0.0}), std::sqrt(8.0 * std::abs(y)), 1e-5 * std::sqrt(std::abs(y)));
}

TEST(ReedsShepp, TinyOffsetsNeedShortWays)
{
  const double angles[] = {0.0, 0.3, 1.0, M_PI / 2, 2.0, M_PI};
  ReedsSheppWords words;
  for (const double size : {1e-3, 1e-6, 1e-9, 1e-11})
    for (const double angle : angles)
      for (const double turn : {-1.0, -0.1, 0.0, 0.1, 1.0})
      {
        const Pose goal{size * std::cos(angle), size * std::sin(angle), size * turn};
        EXPECT_LE(reeds_shepp_length(goal), 4.0 * std::sqrt(size)) << goal;
        reeds_shepp_words(goal, words);
        for (std::size_t i = 0; i < words.count; ++i) EXPECT_LE(error(drive(words.paths[i]), goal), 1e-12) << goal;
      }
}

TEST(ReedsShepp, RejectsAGoalThatIsNotFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const Pose& goal : {Pose{nan, 0, 0}, Pose{0, inf, 0}, Pose{0, 0, nan}})
  {
    EXPECT_THROW(reeds_shepp_length(goal), std::invalid_argument);
    EXPECT_THROW(shortest_reeds_shepp(goal), std::invalid_argument);
  }
}

}  // namespace
}  // namespace fourwis
