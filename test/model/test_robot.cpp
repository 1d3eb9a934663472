#include "fourwis_navigation/model/robot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "../support/exact_polygon.h"
#include "../support/sentences.h"

namespace fourwis
{
namespace
{

using Corners = std::vector<Point2>;

std::string rejection(const Robot& robot)
{
  return error_of<std::invalid_argument>([&] { check(robot); });
}

Robot with_footprint(const Corners& corners)
{
  Robot robot;
  robot.footprint = corners;
  return robot;
}

const Corners kOctagon = {{0.5, 0.2},   {0.35, 0.31},   {-0.35, 0.31}, {-0.5, 0.2},
                          {-0.5, -0.2}, {-0.35, -0.31}, {0.35, -0.31}, {0.5, -0.2}};

TEST(FootprintText, IsThatOfMoveBase)
{
  const PolygonText text{20.0};
  Corners corners;
  ASSERT_TRUE(text.read("[[0.5, 0.3], [-0.5,0.3],[-5e-1 , -.3], [ +0.5, -0.3 ]]", corners));
  EXPECT_EQ(text.write(corners), "[[0.5, 0.3], [-0.5, 0.3], [-0.5, -0.3], [0.5, -0.3]]");
  ASSERT_TRUE(text.read(" [] ", corners));
  EXPECT_TRUE(corners.empty());
  for (const char* bad :
       {"", "[", "[[]]", "[[1]]", "[[1, 2, 3]]", "[1, 2]", "[[1, 2]] 3", "[[1, 2],]", "[[1, 21]]", "[[nan, 1]]",
        "[[0x10, 1]]", "[[010, 1]]", "[[1 2]]", "[[1, 2], [3, 4]", "[[1, 1e400]]", "[[1, ]]"})
    EXPECT_FALSE(text.read(bad, corners)) << bad;
}

TEST(FootprintText, KeepsEveryBit)
{
  const PolygonText text{20.0};
  const Corners corners = {{0.1 + 0.2, -1.0 / 3.0}, {1e-17, 19.999999999999996}};
  Corners read;
  ASSERT_TRUE(text.read(text.write(corners), read));
  ASSERT_EQ(read.size(), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    EXPECT_EQ(read[i].x, corners[i].x);
    EXPECT_EQ(read[i].y, corners[i].y);
  }
}

TEST(OffsetText, IsOnePoint)
{
  Point2 point{};
  ASSERT_TRUE(PointText{20.0}.read("[0.34, 0]", point));
  EXPECT_EQ(point.x, 0.34);
  EXPECT_EQ(point.y, 0.0);
  for (const char* bad : {"0.34", "[0.34]", "[[0.34, 0]]", "[0.34, 0, 0]", "[21, 0]"})
    EXPECT_FALSE(PointText{20.0}.read(bad, point)) << bad;
}

TEST(RobotCheck, TakesConvexFootprintsAroundTheWheelsInEitherSense)
{
  EXPECT_EQ(rejection(with_footprint(kOctagon)), "");
  EXPECT_EQ(rejection(with_footprint({kOctagon.rbegin(), kOctagon.rend()})), "");
  Random random(3);
  for (int k = 0; k < 200; ++k) ASSERT_EQ(rejection(polygon_robot(random)), "") << "seed 3, robot " << k;
}

TEST(RobotCheck, RejectsFootprintsByName)
{
  const std::vector<std::pair<Corners, std::string>> cases = {
      {{{0.5, 0.3}, {-0.5, 0.3}}, "3 to 32 corners"},
      {Corners(40, {0.5, 0.3}), "3 to 32 corners"},
      {{{0.5, 0.4}, {-0.5, 0.4}, {-0.5, -0.4}, {0.5, -0.4}, {0.5, 0.4}, {-0.5, 0.4}, {-0.5, -0.4}, {0.5, -0.4}},
       "corners that differ"},
      {{{0.5, 0.3}, {0.5, 0.3}, {-0.5, 0.3}, {-0.5, -0.3}, {0.5, -0.3}}, "corners that differ"},
      {{{0.5, 0.4}, {0.0, 0.3}, {-0.5, 0.4}, {-0.5, -0.4}, {0.5, -0.4}}, "a convex polygon"},
      {{{0.5, 0.4}, {-0.5, -0.4}, {-0.5, 0.4}, {0.5, -0.4}}, "a convex polygon"},
      // Twice around.
      {{{0.5, 0.0}, {-0.4, 0.3}, {0.15, -0.48}, {0.15, 0.48}, {-0.4, -0.3}}, "a convex polygon"},
      {{{0.5, 0.0}, {0.0, 0.0}, {-0.5, 0.0}}, "an extent of 0.05 m or more"},
      {{{0.3, 0.4}, {-0.5, 0.4}, {-0.5, -0.4}, {0.3, -0.4}}, "a polygon around the four wheels"},
  };
  for (const auto& [corners, expected] : cases)
  {
    const std::string what = rejection(with_footprint(corners));
    EXPECT_TRUE(says(what, "parameter 'footprint' is [["));
    EXPECT_TRUE(says(what, expected));
  }
}

TEST(RobotCheck, LooksForTheWheelsWhereTheyAreInBaseLink)
{
  Robot robot = with_footprint(kOctagon);
  robot.base_offset = {0.34, 0.0};
  EXPECT_TRUE(says(rejection(robot), "one is at [0.68, "));
  for (Point2& corner : robot.footprint) corner.x += 0.34;
  EXPECT_EQ(rejection(robot), "");
}

TEST(RobotCheck, KeepsTheWheelsWithinARectangleThatIsMoved)
{
  Robot robot;
  robot.body_offset = {0.16, -0.05};
  EXPECT_EQ(rejection(robot), "");
  robot.body_offset = {0.17, 0.0};
  EXPECT_TRUE(says(rejection(robot), "'wheelbase' is 0.68"));
  EXPECT_TRUE(says(rejection(robot), "'body_offset' (0.17 m)"));
  robot.body_offset = {0.0, -0.06};
  EXPECT_TRUE(says(rejection(robot), "'track_width' is 0.52"));
}

TEST(RobotCheck, RejectsOffsetsThatAreNoNumbers)
{
  Robot robot;
  robot.base_offset = {NAN, 0.0};
  EXPECT_TRUE(says(rejection(robot), "'base_offset'"));
  robot = with_footprint({{0.5, 0.4}, {-0.5, 0.4}, {-0.5, -INFINITY}});
  EXPECT_TRUE(says(rejection(robot), "'footprint'"));
}

TEST(RobotSize, IsThatOfTheFootprint)
{
  Robot robot = with_footprint({{1.2, 0.0}, {0.6, 0.5}, {-0.6, 0.5}, {-0.6, -0.4}, {0.6, -0.4}});
  EXPECT_DOUBLE_EQ(robot.body_length(), 1.8);
  EXPECT_DOUBLE_EQ(robot.body_width(), 0.9);
  EXPECT_DOUBLE_EQ(robot.size(), 1.8);
}

}  // namespace
}  // namespace fourwis
