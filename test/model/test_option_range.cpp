#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "../support/sentences.h"
#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/model/option_text.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{
namespace
{

constexpr double kInf = std::numeric_limits<double>::infinity();

enum class Colour
{
  red,
  green
};

struct Part
{
  double size = 1.0;

  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("size", o.size, 0.5, 2.0, "m");
  }
};

struct Whole
{
  int count = 3;
  bool flag = false;
  Colour colour = Colour::green;
  std::string name = "x";
  double fixed = 0.0;
  Part left, right;

  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("count", o.count, 2, 9, "pieces");
    row("flag", o.flag);
    row("colour", o.colour, OneOf{"red", "green"});
    row("name", o.name, Word{});
    row.fixed("fixed", o.fixed, -1.0, 1.0);
    row.group("left/", o.left);
    row.group("right/", o.right);
  }
};

template <class Change>
std::string said_of(Change change)
{
  Whole options;
  change(options);
  return error_of<std::invalid_argument>([&] { check_ranges(options); });
}

TEST(OptionRange, ContainsItsEndsAndNoNumberThatIsNone)
{
  const OptionRange range{0.1, 0.3};
  for (const double inside : {0.1, 0.2, 0.3}) EXPECT_TRUE(range.contains(inside)) << inside;
  for (const double outside : {std::nextafter(0.1, 0.0), std::nextafter(0.3, 1.0), kInf, -kInf, std::nan("")})
    EXPECT_FALSE(range.contains(outside)) << outside;
}

TEST(OptionRange, OfWholeNumbersContainsNoFraction)
{
  const OptionRange range{-2, 5, "", true};
  for (const double inside : {-2.0, 0.0, 5.0}) EXPECT_TRUE(range.contains(inside)) << inside;
  for (const double outside : {-1.5, 0.001, 4.999, -3.0, 6.0, std::nan("")})
    EXPECT_FALSE(range.contains(outside)) << outside;
}

TEST(OptionRange, IsNamedWithOptionAndValue)
{
  const auto said = [](const OptionRange& range, double value) {
    return error_of<std::invalid_argument>([&] { require_in(range, "speed", value); });
  };
  EXPECT_EQ(said({0.01, 20.0, "m/s"}, 0.0), "parameter 'speed' is 0, expected a number from 0.01 to 20 m/s");
  EXPECT_EQ(said({1, 8, "", true}, 2.5), "parameter 'speed' is 2.5, expected a whole number from 1 to 8");
  EXPECT_EQ(said({0.0, 1.0}, std::nan("")), "parameter 'speed' is nan, expected a number from 0 to 1");
  EXPECT_EQ(said({0.0, 1.0}, 0.5), "");
}

TEST(OptionRange, NumbersAreWrittenSoThatTheyReadBackTheSame)
{
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(4294967295.0), "4294967295");
  EXPECT_EQ(to_text(1e9), "1e+09");
  for (const double number :
       {M_PI * 80 / 180, std::nextafter(20.0, 21.0), 1.0 / 3.0, -1e-300, std::numeric_limits<double>::denorm_min()})
    EXPECT_EQ(std::strtod(to_text(number).c_str(), nullptr), number);
}

TEST(OptionRange, PositiveMeansFiniteToo)
{
  EXPECT_NO_THROW(require_positive("speed", 1e-300));
  for (const double bad : {0.0, -1.0, kInf, std::nan("")})
    EXPECT_TRUE(says(error_of<std::invalid_argument>([&] { require_positive("speed", bad); }), "'speed' is "));
}

TEST(OptionCheck, EveryKindOfMemberIsCheckedByName)
{
  EXPECT_EQ(said_of([](Whole&) {}), "");
  EXPECT_TRUE(says(said_of([](Whole& o) { o.count = 1; }), "'count' is 1, expected a whole number from 2 to 9 pieces"));
  EXPECT_TRUE(says(said_of([](Whole& o) { o.count = 10; }), "'count' is 10, "));
  EXPECT_TRUE(
      says(said_of([](Whole& o) { o.colour = static_cast<Colour>(2); }), "'colour' is '', expected one of red, green"));
  EXPECT_TRUE(says(said_of([](Whole& o) { o.name = ""; }), "'name' is '', expected a word"));
  EXPECT_TRUE(says(said_of([](Whole& o) { o.fixed = std::nan(""); }), "'fixed' is nan"));
  EXPECT_TRUE(
      says(said_of([](Whole& o) { o.left.size = 0.0; }), "'left/size' is 0, expected a number from 0.5 to 2 m"));
  EXPECT_TRUE(says(said_of([](Whole& o) { o.right.size = 3.0; }), "'right/size' is 3"));
}

TEST(OptionCheck, TheRobotsWheelsLieWithinItsBody)
{
  Robot robot;
  EXPECT_NO_THROW(check(robot));
  robot.wheelbase = robot.length;
  robot.track_width = robot.width;
  EXPECT_NO_THROW(check(robot));
  robot.track_width += 0.01;
  EXPECT_TRUE(
      says(error_of<std::invalid_argument>([&] { check(robot); }), "'track_width' is 0.63, expected at most 'width'"));
  robot = {};
  robot.max_speed = std::nan("");
  EXPECT_TRUE(says(error_of<std::invalid_argument>([&] { check(robot); }), "'max_speed' is nan"));
}

}  // namespace
}  // namespace fourwis
