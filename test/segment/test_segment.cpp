#include "fourwis_navigation/segment/segment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "random_path.h"

namespace fourwis
{
namespace
{

constexpr double kSpacing = 0.2;
const Robot kRobot;

/// Indices of the intervals that begin a run, and the number of intervals at the end.
std::vector<std::size_t> run_borders(const Segment& segment)
{
  std::vector<std::size_t> borders{0};
  for (std::size_t i = 1; i < segment.intervals(); ++i)
    if ((segment.length[i] < 0.0) != (segment.length[i - 1] < 0.0)) borders.push_back(i);
  borders.push_back(segment.intervals());
  return borders;
}

double gap(const Pose& a, const Pose& b)
{
  return std::max(distance(a, b), std::abs(wrap_angle(a.theta - b.theta)));
}

/// The pose after `travelled` metres of a path.
Pose pose_after(const Path& path, double travelled)
{
  for (const PathPiece& piece : path.pieces)
  {
    const double length = std::abs(piece.length);
    if (travelled <= length)
      return advance(kRobot, piece.start, piece.mode, piece.phi, std::copysign(travelled, piece.length));
    travelled -= length;
  }
  return path.goal;
}

class RandomPaths : public testing::Test
{
protected:
  template <typename Law>
  void for_each(Law law)
  {
    for (unsigned seed = 1; seed <= 300; ++seed)
    {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      Random random(seed);
      const Path path = random_path(kRobot, random);
      law(path, split_at_switches(path, kRobot, kSpacing));
      if (HasFailure()) return;
    }
  }
};

TEST_F(RandomPaths, KnotsLieOnThePathAtTheDistanceTheIntervalsAddUpTo)
{
  for_each([](const Path& path, const std::vector<Segment>& segments) {
    double travelled = 0.0;
    for (const Segment& segment : segments)
    {
      ASSERT_EQ(segment.knots.size(), segment.intervals() + 1);
      ASSERT_EQ(segment.length.size(), segment.intervals());
      EXPECT_LT(gap(segment.knots.front(), pose_after(path, travelled)), 1e-9);
      for (std::size_t i = 0; i < segment.intervals(); ++i)
      {
        travelled += std::abs(segment.length[i]);
        EXPECT_LT(gap(segment.knots[i + 1], pose_after(path, travelled)), 1e-9);
      }
    }
    EXPECT_NEAR(travelled, path.length(), 1e-9);
    EXPECT_LT(gap(segments.back().knots.back(), path.goal), 1e-9);
  });
}

TEST_F(RandomPaths, SegmentsSwitchModesWhereThePathDoes)
{
  for_each([](const Path& path, const std::vector<Segment>& segments) {
    ASSERT_EQ(segments.size(), static_cast<std::size_t>(path.switches()) + 1);
    std::size_t segment = 0;
    for (std::size_t i = 0; i < path.pieces.size(); ++i)
    {
      if (i > 0 && path.pieces[i].mode != path.pieces[i - 1].mode)
      {
        ++segment;
        EXPECT_LT(gap(segments[segment].knots.front(), path.pieces[i].start), 1e-9);
      }
      EXPECT_EQ(segments[segment].mode, path.pieces[i].mode);
    }
  });
}

TEST_F(RandomPaths, IntervalsOfARunAreEqualAndNoLongerThanTheSpacing)
{
  for_each([](const Path&, const std::vector<Segment>& segments) {
    for (const Segment& segment : segments)
    {
      const std::vector<std::size_t> borders = run_borders(segment);
      for (std::size_t run = 0; run + 1 < borders.size(); ++run)
      {
        EXPECT_GE(borders[run + 1] - borders[run], 4u);
        const double step = std::abs(segment.length[borders[run]]);
        EXPECT_LE(step, kSpacing * (1.0 + 1e-6));
        EXPECT_TRUE(borders[run + 1] - borders[run] == 4 || step > 0.79 * kSpacing) << step;
        for (std::size_t i = borders[run]; i < borders[run + 1]; ++i)
          EXPECT_DOUBLE_EQ(std::abs(segment.length[i]), step);
      }
    }
  });
}

TEST_F(RandomPaths, EveryCuspIsAKnot)
{
  for_each([](const Path& path, const std::vector<Segment>& segments) {
    for (std::size_t i = 1; i < path.pieces.size(); ++i)
    {
      const PathPiece &before = path.pieces[i - 1], &after = path.pieces[i];
      if (before.mode != after.mode || before.mode == Mode::parallel || before.length * after.length > 0.0) continue;
      const auto ends_here = [&](const Segment& segment) {
        const std::vector<std::size_t> borders = run_borders(segment);
        return std::any_of(borders.begin(), borders.end(),
                           [&](std::size_t b) { return gap(segment.knots[b], after.start) < 1e-9; });
      };
      EXPECT_TRUE(std::any_of(segments.begin(), segments.end(), ends_here)) << "piece " << i;
    }
  });
}

TEST_F(RandomPaths, HeadingsNeverJumpEvenWhereThePathWrapsThem)
{
  for_each([](Path path, const std::vector<Segment>&) {
    for (PathPiece& piece : path.pieces) piece.start.theta = wrap_angle(piece.start.theta);
    const std::vector<Segment> segments = split_at_switches(path, kRobot, kSpacing);
    double last = segments.front().knots.front().theta;
    for (const Segment& segment : segments)
      for (std::size_t i = 0; i < segment.knots.size(); ++i)
      {
        const double step = i == 0 ? 0.0 : std::abs(segment.length[i - 1]);
        EXPECT_LE(std::abs(segment.knots[i].theta - last), step * max_curvature(kRobot, segment.mode) + 1e-9);
        last = segment.knots[i].theta;
      }
  });
}

TEST_F(RandomPaths, TheMeanAnglesKeepTheIntegralOfTheAngleOverLength)
{
  for_each([](const Path& path, const std::vector<Segment>& segments) {
    auto piece = path.pieces.begin();
    for (const Segment& segment : segments)
    {
      double on_path = 0.0, on_segment = 0.0;
      for (; piece != path.pieces.end() && piece->mode == segment.mode; ++piece)
        on_path += piece->phi * std::abs(piece->length);
      for (std::size_t i = 0; i < segment.intervals(); ++i) on_segment += segment.phi[i] * std::abs(segment.length[i]);
      if (segment.mode == Mode::parallel) continue;
      EXPECT_NEAR(on_path, on_segment, 1e-9);
    }
  });
}

/// Parallel pieces of at least two intervals each, with angles a path may have: within a right angle to either side.
Path random_parallel_path(Random& random)
{
  Path path = path_from({});
  for (int i = 0; i < 8; ++i)
  {
    const double length = (random.chance(0.5) ? 1.0 : -1.0) * random.between(2.0 * kSpacing, 1.0);
    append(path, kRobot, Mode::parallel, random.steering(kRobot, Mode::parallel), length);
  }
  return path;
}

TEST(ParallelSegment, WheelsThatTurnFreelyNeverTurnByMoreThanARightAngle)
{
  Robot robot;
  robot.wheel_max_angle = 100.0;
  for (unsigned seed = 1; seed <= 300; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Segment segment = split_at_switches(random_parallel_path(random), robot, kSpacing).at(0);
    for (std::size_t i = 1; i < segment.intervals(); ++i)
      ASSERT_LE(std::abs(segment.phi[i] - segment.phi[i - 1]), M_PI_2 + 1e-6);
  }
}

TEST(ParallelSegment, WheelsOfLimitedTravelCanFollowWithoutAJump)
{
  for (unsigned seed = 1; seed <= 300; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Segment segment = split_at_switches(random_parallel_path(random), kRobot, kSpacing).at(0);
    const auto range = std::minmax_element(segment.phi.begin(), segment.phi.end());
    ASSERT_GE(*range.first, -kRobot.wheel_max_angle);
    ASSERT_LE(*range.second, kRobot.wheel_max_angle);
  }
}

TEST(Segment, HeldSteeringRollsOutFromKnotToKnotExactly)
{
  for (Mode mode : kPlannedModes)
  {
    Path path = path_from({1.0, -2.0, 3.0});
    append(path, kRobot, mode, 0.4, 3.33);
    const Segment segment = split_at_switches(path, kRobot, kSpacing).at(0);
    EXPECT_EQ(segment.intervals(), 17u);
    for (std::size_t i = 0; i < segment.intervals(); ++i)
    {
      const Pose end = advance(kRobot, segment.knots[i], mode, segment.phi[i], segment.length[i]);
      EXPECT_LT(gap(end, segment.knots[i + 1]), 1e-12);
    }
  }
}

TEST(Segment, ALengthThatIsAMultipleOfTheSpacingIsCutIntoThatMany)
{
  for (int count = 4; count < 300; ++count)
  {
    // Summed up piece by piece, so that it is a rounding more or less.
    Path path = path_from({});
    for (int i = 0; i < count; ++i) append(path, kRobot, Mode::ackermann, 0.1, kSpacing);
    EXPECT_EQ(split_at_switches(path, kRobot, kSpacing).at(0).intervals(), static_cast<std::size_t>(count));
  }
}

TEST(Segment, AnIntervalInWhichTheWheelsTurnHasTheMeanByLength)
{
  Path path = path_from({});
  append(path, kRobot, Mode::ackermann, 0.1, 0.25);
  append(path, kRobot, Mode::ackermann, 0.5, 0.75);
  const Segment segment = split_at_switches(path, kRobot, kSpacing).at(0);
  ASSERT_EQ(segment.intervals(), 5u);
  EXPECT_NEAR(segment.phi[0], 0.1, 1e-12);
  EXPECT_NEAR(segment.phi[1], 0.25 * 0.1 + 0.75 * 0.5, 1e-12);
  EXPECT_NEAR(segment.phi[2], 0.5, 1e-12);
}

TEST(Segment, ParallelPiecesThatReverseByTurningTheWheelsBecomeACusp)
{
  Path path = path_from({});
  append(path, kRobot, Mode::parallel, 0.3, 1.0);
  append(path, kRobot, Mode::parallel, 0.4 - M_PI, 1.0);
  const Segment segment = split_at_switches(path, kRobot, kSpacing).at(0);
  ASSERT_EQ(segment.intervals(), 10u);
  EXPECT_NEAR(segment.phi[9], 0.4, 1e-12);
  EXPECT_NEAR(segment.length[9], -0.2, 1e-12);
  EXPECT_LT(gap(segment.knots.back(), path.goal), 1e-12);
}

TEST(Segment, AParallelCornerOfARightAngleKeepsTheDirection)
{
  for (double corner : {M_PI_2, -M_PI_2})
  {
    Path path = path_from({});
    append(path, kRobot, Mode::parallel, -corner / 2, 1.0);
    append(path, kRobot, Mode::parallel, corner / 2, 1.0);
    const Segment segment = split_at_switches(path, kRobot, kSpacing).at(0);
    EXPECT_NEAR(segment.phi.back(), corner / 2, 1e-12);
    EXPECT_GT(segment.length.back(), 0.0);
  }
}

TEST(Segment, ParallelAnglesStayWithinTheWheelsTravel)
{
  // A course that turns on and on by 60 degrees: a wheel that turns by +-160 degrees cannot follow without a jump.
  Path path = path_from({});
  for (int i = 0; i < 12; ++i) append(path, kRobot, Mode::parallel, i * M_PI / 3.0, 1.0);
  const Segment segment = split_at_switches(path, kRobot, kSpacing).at(0);
  const auto range = std::minmax_element(segment.phi.begin(), segment.phi.end());
  EXPECT_LE(*range.second - *range.first, 2.0 * kRobot.wheel_max_angle);
  EXPECT_LT(gap(segment.knots.back(), path.goal), 1e-9);
}

TEST(Segment, AMillimetreIsEnoughForASegment)
{
  Path path = path_from({1.0, 1.0, 1.0});
  append(path, kRobot, Mode::lateral, 0.2, -1e-3);
  const std::vector<Segment> segments = split_at_switches(path, kRobot, kSpacing);
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].intervals(), 4u);
  EXPECT_NEAR(travel_length(segments[0]), 1e-3, 1e-15);
}

TEST(Segment, PiecesWithoutLengthAreDroppedWithTheirSwitches)
{
  Path path = path_from({});
  append(path, kRobot, Mode::parallel, 0.3, 0.0);
  append(path, kRobot, Mode::ackermann, 0.1, 1.0);
  append(path, kRobot, Mode::ackermann, -0.1, 0.0);
  append(path, kRobot, Mode::lateral, 0.1, 0.0);
  append(path, kRobot, Mode::parallel, 0.1, -0.0);
  append(path, kRobot, Mode::ackermann, 0.1, 1.0);
  append(path, kRobot, Mode::lateral, 0.1, 1e-9);
  const std::vector<Segment> segments = split_at_switches(path, kRobot, kSpacing);
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].mode, Mode::ackermann);
  EXPECT_EQ(segments[0].intervals(), 10u);
}

TEST(Segment, ThereIsNothingToDriveOnAPathWithoutMotion)
{
  EXPECT_TRUE(split_at_switches({}, kRobot, kSpacing).empty());
  Path path = path_from({});
  append(path, kRobot, Mode::ackermann, 0.3, 0.0);
  EXPECT_TRUE(split_at_switches(path, kRobot, kSpacing).empty());
}

TEST(Segment, UnusablePathsGiveNoSegments)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  Path good = path_from({});
  append(good, kRobot, Mode::ackermann, 0.1, 1.0);
  append(good, kRobot, Mode::ackermann, 0.2, 1.0);
  ASSERT_EQ(split_at_switches(good, kRobot, kSpacing).size(), 1u);

  const auto refuses = [&](auto change) {
    Path path = good;
    change(path.pieces[1]);
    return split_at_switches(path, kRobot, kSpacing).empty();
  };
  for (double value : {nan, infinity, -infinity})
  {
    EXPECT_TRUE(refuses([&](PathPiece& piece) { piece.start.x = value; }));
    EXPECT_TRUE(refuses([&](PathPiece& piece) { piece.start.y = value; }));
    EXPECT_TRUE(refuses([&](PathPiece& piece) { piece.start.theta = value; }));
    EXPECT_TRUE(refuses([&](PathPiece& piece) { piece.phi = value; }));
    EXPECT_TRUE(refuses([&](PathPiece& piece) { piece.length = value; }));
  }
  EXPECT_TRUE(refuses([](PathPiece& piece) { piece.mode = Mode::none; }));
  EXPECT_TRUE(refuses([](PathPiece& piece) { piece.mode = Mode::spin; }));
  EXPECT_TRUE(refuses([](PathPiece& piece) { piece.start.x += 0.01; })) << "a gap";
  EXPECT_TRUE(refuses([](PathPiece& piece) { piece.start.theta += 0.01; })) << "a jump of the heading";
  EXPECT_TRUE(refuses([](PathPiece& piece) { piece.length = 1e9; })) << "more intervals than memory";
  Robot robot;
  robot.wheelbase = 0.0;
  EXPECT_TRUE(split_at_switches(good, robot, kSpacing).empty());
}

TEST(Segment, TheReferenceDurationIsLengthOverSpeed)
{
  Path path = path_from({});
  append(path, kRobot, Mode::ackermann, 0.1, 1.0);
  append(path, kRobot, Mode::ackermann, 0.2, -2.0);
  const Segment segment = split_at_switches(path, kRobot, kSpacing).at(0);
  EXPECT_NEAR(reference_duration(segment, 1.5), 2.0, 1e-12);
  EXPECT_NEAR(travel_length(segment), 3.0, 1e-12);
}

TEST(Segment, ASpacingOrSpeedThatIsNotPositiveIsABug)
{
  for (double value : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
  {
    EXPECT_THROW(split_at_switches({}, kRobot, value), std::invalid_argument) << value;
    EXPECT_THROW(reference_duration({}, value), std::invalid_argument) << value;
  }
}

}  // namespace
}  // namespace fourwis
