#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "fourwis_navigation/model/fingerprint.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{
namespace
{

struct Size
{
  double size = 2.0;

  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("size", o.size, 0.0, 10.0);
  }
};

/// A reader of a table that changes the number of one row by as little as possible.
struct Nudge
{
  int row, seen = 0;

  void operator()(std::string_view, double& value, double, double, const char* = "")
  {
    if (seen++ == row) value = std::nextafter(value, std::numeric_limits<double>::infinity());
  }

  template <class Text>
  void operator()(std::string_view key, Point2& point, const Text&)
  {
    (*this)(key, point.x, 0.0, 0.0);
    (*this)(key, point.y, 0.0, 0.0);
  }

  template <class Text>
  void operator()(std::string_view, std::vector<Point2>& polygon, const Text&)
  {
    if (seen++ == row) polygon = {{0.0, 0.0}};
  }
};

TEST(Fingerprint, is_fnv_1a_of_lines_with_key_and_value)
{
  // Of "size=2\n", computed elsewhere.
  EXPECT_EQ(fingerprint(Size{}), "62488eeb3577e4db");
}

TEST(Fingerprint, of_equal_robots_is_the_same)
{
  EXPECT_EQ(fingerprint(Robot{}), fingerprint(Robot{}));
  EXPECT_EQ(fingerprint(Robot{}).size(), 16u);
}

TEST(Fingerprint, of_robots_that_differ_in_the_last_digit_of_any_key_is_another)
{
  std::set<std::string> seen = {fingerprint(Robot{})};
  Nudge all{-1};
  Robot robot;
  Robot::describe(robot, all);
  for (int row = 0; row < all.seen; ++row)
  {
    Nudge nudge{row};
    Robot nudged;
    Robot::describe(nudged, nudge);
    EXPECT_TRUE(seen.insert(fingerprint(nudged)).second) << "row " << row;
  }
}

TEST(Fingerprint, does_not_tell_zeros_apart)
{
  EXPECT_EQ(fingerprint(Size{0.0}), fingerprint(Size{-0.0}));
}

}  // namespace
}  // namespace fourwis
