#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../support/grids.h"
#include "cli/cell_rectangles.h"
#include "cli/motion_samples.h"
#include "cli/picture.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 7;

/// Of eleven cells six are free, three occupied and two unknown.
OccupancyGrid random_grid(Random& random, int width, int height)
{
  OccupancyGrid grid = free_grid(width, height, 0.1, {-1.0, 2.0, 0.4});
  for (std::int8_t& value : grid.data)
  {
    const int kind = random.whole(1, 11);
    value = kind <= 6 ? 0 : kind <= 9 ? 100 : -1;
  }
  return grid;
}

TEST(CellRectangles, CoverEachWantedCellOnceAndNoOther)
{
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  for (int trial = 0; trial < 200; ++trial)
  {
    const int width = random.whole(1, 12), height = random.whole(1, 12);
    const OccupancyGrid grid = random_grid(random, width, height);
    const auto wanted = [](std::int8_t cell) { return cell == 100; };
    std::vector<int> covered(grid.data.size(), 0);
    for (const CellRectangle& r : cell_rectangles(grid, wanted))
      for (int row = r.bottom; row < r.top; ++row)
        for (int column = r.left; column < r.right; ++column)
          ++covered.at(static_cast<std::size_t>(row * grid.width + column));
    for (std::size_t i = 0; i < covered.size(); ++i) EXPECT_EQ(covered[i], wanted(grid.data[i]) ? 1 : 0);
  }
}

TEST(CellRectangles, MergeABlockToOne)
{
  OccupancyGrid grid = free_grid(30, 20, 0.1);
  occupy_block(grid, 0, 0, 30, 20);
  EXPECT_EQ(cell_rectangles(grid, [](std::int8_t cell) { return cell == 100; }).size(), 1u);
}

TEST(CellRectangles, KnownBlockIsTheLeastAndTheWholeGridWhereNothingIsKnown)
{
  OccupancyGrid grid = free_grid(9, 7, 0.1);
  std::fill(grid.data.begin(), grid.data.end(), -1);
  const auto block = [&] {
    const CellRectangle r = known_block(grid);
    return std::vector<int>{r.left, r.bottom, r.right, r.top};
  };
  EXPECT_EQ(block(), std::vector<int>({0, 0, 9, 7}));
  cell(grid, 3, 2) = 0;
  occupy(grid, 7, 4);
  EXPECT_EQ(block(), std::vector<int>({3, 2, 8, 5}));
}

TrajectoryPoint point(double t, Mode mode, const Pose& pose, double v, double phi)
{
  return {t, mode, pose.x, pose.y, pose.theta, v, phi, 0.0, 0.0};
}

TEST(MotionSamples, LieOnTheExactArcAtMostAStepApart)
{
  const Robot robot;
  for (const Mode mode : kPlannedModes)
    for (const double phi : {0.0, 0.3, -0.5})
      for (const double speed : {1.0, -0.7})
      {
        const Pose start{1.0, -2.0, 0.5};
        const double duration = 2.0;
        const Trajectory trajectory = {
            point(0.0, mode, start, speed, phi),
            point(duration, mode, advance(robot, start, mode, phi, speed * duration), speed, phi)};
        const std::vector<ModeRun> runs = sample_motion(robot, trajectory, 0.02);
        ASSERT_EQ(runs.size(), 1u);
        const std::vector<Pose>& poses = runs[0].poses;
        for (std::size_t i = 0; i < poses.size(); ++i)
        {
          const double s = speed * duration * static_cast<double>(i) / static_cast<double>(poses.size() - 1);
          const Pose exact = advance(robot, start, mode, phi, s);
          EXPECT_LT(distance(poses[i], exact), 1e-3) << to_string(mode) << " phi " << phi << " sample " << i;
          EXPECT_NEAR(poses[i].theta, exact.theta, 1e-9);
          EXPECT_LE(distance(poses[i], poses[i == 0 ? 0 : i - 1]), 0.0201);
        }
      }
}

TEST(MotionSamples, RunsChangeWithTheModeAndKeepTheEnds)
{
  const Pose a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0};
  const Trajectory trajectory = {point(0, Mode::ackermann, a, 0, 0), point(2, Mode::ackermann, b, 0, 0),
                                 point(3, Mode::lateral, b, 0, 0), point(5, Mode::lateral, c, 0, 0)};
  const std::vector<ModeRun> runs = sample_motion(Robot(), trajectory, 0.1);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].mode, Mode::ackermann);
  EXPECT_EQ(runs[1].mode, Mode::lateral);
  EXPECT_EQ(distance(runs[0].poses.front(), a), 0.0);
  EXPECT_EQ(distance(runs[0].poses.back(), b), 0.0);
  EXPECT_EQ(distance(runs[1].poses.front(), b), 0.0);
  EXPECT_EQ(distance(runs[1].poses.back(), c), 0.0);
}

/// std::regex recurses and cannot take the long attributes.
std::string without_path_data(std::string tag)
{
  const std::size_t begin = tag.find(" d=\"");
  if (begin == std::string::npos) return tag;
  const std::size_t end = tag.find('"', begin + 4);
  return tag.erase(begin, end == std::string::npos ? end : end + 1 - begin);
}

/// Whether tags are balanced and attributes quoted: what a browser refuses first.
testing::AssertionResult is_well_formed(const std::string& xml)
{
  static const std::regex tag("<(/?)([A-Za-z][\\w:-]*)((?:\\s+[\\w:-]+=\"[^\"<&]*\")*)\\s*(/?)>");
  std::vector<std::string> open;
  std::size_t at = xml.find("?>") + 2;
  while ((at = xml.find_first_of("<&>", at)) != std::string::npos)
  {
    if (xml[at] == '&')
    {
      if (!std::regex_search(xml.begin() + static_cast<long>(at), xml.end(), std::regex("^&(amp|lt|gt);")))
        return testing::AssertionFailure() << "bare & in " << xml.substr(at, 40);
      ++at;
      continue;
    }
    const std::size_t end = xml.find('>', at);
    if (xml[at] == '>' || end == std::string::npos)
      return testing::AssertionFailure() << "stray " << xml.substr(at, 40);
    const std::string text = without_path_data(xml.substr(at, end - at + 1));
    std::smatch match;
    if (!std::regex_match(text, match, tag)) return testing::AssertionFailure() << "no tag: " << text.substr(0, 200);
    if (match[1].length() == 0 && match[4].length() == 0) open.push_back(match[2]);
    if (match[1].length() > 0)
    {
      if (open.empty() || open.back() != match[2]) return testing::AssertionFailure() << "unmatched " << text;
      open.pop_back();
    }
    at = end + 1;
  }
  return open.empty() ? testing::AssertionSuccess() : testing::AssertionFailure() << "not closed: " << open.back();
}

/// A plan through all modes on a turned grid.
PlanResult plan_in_all_modes(const Robot& robot, const Pose& start)
{
  PlanResult result;
  result.status = PlanStatus::succeeded;
  Pose pose = start;
  double t = 0.0;
  for (const Mode mode : kPlannedModes)
  {
    result.trajectory.push_back(point(t, mode, pose, 0.3, 0.2));
    pose = advance(robot, pose, mode, 0.2, 0.3);
    result.trajectory.push_back(point(t + 1.0, mode, pose, 0.3, 0.2));
    t += 2.0;
  }
  return result;
}

std::string drawn(const OccupancyGrid& grid, const PlanResult& result, const Pose& start, const Pose& goal,
                  const std::vector<Corridor>& corridors = {})
{
  const Robot robot;
  std::ostringstream svg;
  write_svg(svg, {grid, ObstacleRule(), robot, start, goal, result, corridors});
  return svg.str();
}

std::size_t count(const std::string& text, const std::string& part)
{
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Picture, OfAPlanShowsEveryModeInItsColourAndEverySwitch)
{
  Random random(kSeed);
  const OccupancyGrid grid = random_grid(random, 60, 40);
  const Pose start{1.0, 4.0, 0.3};
  const std::string svg = drawn(grid, plan_in_all_modes(Robot(), start), start, {1.5, 4.5, 1.0});
  EXPECT_TRUE(is_well_formed(svg));
  for (const Mode mode : kPlannedModes)
  {
    EXPECT_EQ(count(svg, std::string("class=\"centre ") + to_string(mode)), 1u);
    EXPECT_EQ(count(svg, std::string("class=\"footprints ") + to_string(mode)), 1u);
    // Footprint outline and fill, centre line, legend.
    EXPECT_EQ(count(svg, svg_colour(mode)), 4u) << to_string(mode);
  }
  EXPECT_EQ(count(svg, "class=\"switch\""), 2u);
  EXPECT_EQ(count(svg, "class=\"start\""), 1u);
  EXPECT_EQ(count(svg, "class=\"goal\""), 1u);
  EXPECT_EQ(count(svg, "succeeded"), 1u);
}

TEST(Picture, ModesHaveDifferentColours)
{
  EXPECT_NE(svg_colour(Mode::ackermann), svg_colour(Mode::lateral));
  EXPECT_NE(svg_colour(Mode::ackermann), svg_colour(Mode::parallel));
  EXPECT_NE(svg_colour(Mode::lateral), svg_colour(Mode::parallel));
  EXPECT_EQ(svg_colour(Mode::ackermann), "#1f6fd1");
}

TEST(Picture, WithoutATrajectoryShowsTheQuestionAndSaysWhy)
{
  Random random(kSeed);
  PlanResult result;
  result.status = PlanStatus::goal_in_collision;
  result.message = "the goal <1, 2> & \"more\"\n\x01\xff";
  const std::string svg = drawn(random_grid(random, 20, 30), result, {0, 3, 0}, {0, 4, 0});
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, "goal_in_collision"), 1u);
  EXPECT_EQ(count(svg, "the goal &lt;1, 2&gt; &amp;"), 1u);
  EXPECT_EQ(count(svg, "class=\"start\""), 1u);
}

TEST(Picture, OfAnythingIsWellFormed)
{
  Random random(kSeed);
  PlanResult odd;
  odd.trajectory = {point(0.0, Mode::none, {0, 3, 0}, 1.0, 0.0), point(1.0, Mode::ackermann, {NAN, 0, 0}, 1.0, 0.0),
                    point(-1.0, Mode::none, {0, 3, 1}, INFINITY, 0.0), point(-2.0, Mode::spin, {0, 4, 1}, 0.0, 0.0)};
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(300, 1), std::pair(1, 300), std::pair(40, 40)})
  {
    const std::string svg = drawn(random_grid(random, width, height), odd, {1e9, 0, 0}, {0, -1e9, 0});
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_EQ(count(svg, "nan"), 0u);
    EXPECT_EQ(count(svg, "inf"), 0u);
  }
}

/// The matrix(a b c d e f) of the group of cells.
std::vector<double> matrix_in(const std::string& svg)
{
  std::vector<double> numbers(6);
  const std::size_t at = svg.find("matrix(");
  std::istringstream stream(svg.substr(at + 7, 200));
  for (double& number : numbers) stream >> number;
  return numbers;
}

TEST(Picture, CellsAndPosesAgreeOnATurnedGrid)
{
  const OccupancyGrid grid = free_grid(50, 30, 0.2, {3.0, -1.0, 0.7});
  // A robot in the middle of cell (20, 10): its switch marker must be drawn where that cell is drawn.
  const Pose middle = compose(grid.origin, {20.5 * 0.2, 10.5 * 0.2, 0.0});
  PlanResult result;
  result.trajectory = {point(0.0, Mode::ackermann, middle, 0, 0), point(1.0, Mode::lateral, middle, 0, 0)};
  const std::string svg = drawn(grid, result, middle, middle);

  const std::vector<double> m = matrix_in(svg);
  const double x = m[0] * 20.5 + m[2] * 10.5 + m[4], y = m[1] * 20.5 + m[3] * 10.5 + m[5];
  const std::size_t at = svg.find("class=\"switch\"");
  ASSERT_NE(at, std::string::npos);
  double cx = 0.0, cy = 0.0;
  ASSERT_EQ(std::sscanf(svg.c_str() + at, "class=\"switch\" cx=\"%lf\" cy=\"%lf\"", &cx, &cy), 2);
  EXPECT_NEAR(cx, x, 0.05);
  EXPECT_NEAR(cy, y, 0.05);
}

/// The half-planes of a rectangle.
Polytope region(double x_min, double y_min, double x_max, double y_max)
{
  return {{-1, 0, -x_min}, {0, -1, -y_min}, {1, 0, x_max}, {0, 1, y_max}};
}

TEST(Picture, CorridorsAreDrawnWhereTheyAreRegionByRegionBelowThePlan)
{
  const OccupancyGrid grid = free_grid(40, 20, 0.1, {3.0, -1.0, 0.0});
  const Pose pose{5.0, 0.0, 0.0};
  const std::vector<Corridor> corridors = {{{{0.25, 0.0}, {region(4, -0.5, 5, 0.5), region(4.5, -0.5, 5.5, 0.5)}},
                                            {{-0.25, 0.0}, {region(3.5, 0, 4, 0.25)}}},
                                           {{{0.25, 0.0}, {region(6, 0, 6.5, 0.5)}}}};
  const std::string svg = drawn(grid, plan_in_all_modes(Robot(), pose), pose, pose, corridors);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, ">corridors<"), 1u);

  const auto data_of = [&](const std::string& disc) {
    const std::string begin = "class=\"corridor " + disc + "\" d=\"";
    const std::size_t at = svg.find(begin) + begin.size();
    return svg.substr(at, svg.find('"', at) - at);
  };
  EXPECT_EQ(count(data_of("disc0"), "M"), 3u);
  EXPECT_LT(svg.find("class=\"corridor"), svg.find("class=\"footprints"));

  // The cell (5, 10) has its lower left corner at (3.5, 0).
  const std::vector<double> m = matrix_in(svg);
  double x = 0.0, y = 0.0, right = 0.0, top = 0.0;
  ASSERT_EQ(std::sscanf(data_of("disc1").c_str(), "M%lf,%lfL%*f,%*fL%lf,%lfL", &x, &y, &right, &top), 4)
      << data_of("disc1");
  EXPECT_NEAR(std::min(x, right), m[0] * 5 + m[4], 0.05);
  EXPECT_NEAR(std::max(x, right), m[0] * 10 + m[4], 0.05);
  EXPECT_NEAR(std::max(y, top), m[3] * 10 + m[5], 0.05);
  EXPECT_NEAR(std::min(y, top), m[3] * 12.5 + m[5], 0.05);
}

TEST(Picture, IterationsAreDrawnTheLaterTheDarker)
{
  const OccupancyGrid grid = free_grid(40, 20, 0.1);
  const Robot robot;
  const PlanResult result = plan_in_all_modes(robot, {1.0, 1.0, 0.0});
  std::ostringstream svg;
  write_svg(svg, {grid, ObstacleRule(), robot, {}, {}, result, {}, {result.trajectory, result.trajectory}});
  EXPECT_TRUE(is_well_formed(svg.str()));
  EXPECT_EQ(count(svg.str(), "class=\"iteration\""), 2u);
  EXPECT_LT(svg.str().find("stroke-opacity=\"0.45\""), svg.str().find("stroke-opacity=\"0.9\""));
  EXPECT_EQ(count(svg.str(), ">iterations<"), 1u);
}

TEST(Picture, WithoutCorridorsDoesNotMentionThem)
{
  const OccupancyGrid grid = free_grid(40, 20, 0.1);
  EXPECT_EQ(count(drawn(grid, plan_in_all_modes(Robot(), {}), {}, {}), "corridor"), 0u);
  EXPECT_EQ(count(drawn(grid, plan_in_all_modes(Robot(), {}), {}, {}), "iteration"), 0u);
}

}  // namespace
}  // namespace fourwis
