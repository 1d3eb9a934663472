#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "complaint.h"

namespace fourwis
{
namespace
{

const std::string kRobotFile = FOURWIS_SOURCE_DIR "/config/robot.yaml";
const std::string kPlannerFile = FOURWIS_SOURCE_DIR "/config/planner.yaml";

/// A parameter file of the test, gone afterwards.
class ParameterFile : public testing::Test
{
protected:
  ~ParameterFile() override { std::remove(path_.c_str()); }

  std::string write(const std::string& text)
  {
    std::ofstream(path_) << text;
    return path_;
  }
  /// What reading `text` throws; empty when nothing.
  std::string rejection(const std::string& text)
  {
    return complaint(+[](const ParameterMap& path) { return read_parameter_file(path.begin()->first); },
                     {{write(text), true}});
  }

  std::string path_ = testing::TempDir() + "fourwis_parameters_" +
                      testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml";
};

TEST_F(ParameterFile, ValuesHaveTheTypeOfTheirYaml)
{
  const ParameterMap parameters = read_parameter_file(
      write("a: 1\nb: -2.5e-1\nc: true\nd: 'true'\ne: word\nf: \"3\"\ng: off\nh: y\ni: .inf\nouter: {inner: 4}\n"));
  const ParameterMap expected = {{"a", 1.0},
                                 {"b", -0.25},
                                 {"c", true},
                                 {"d", std::string("true")},
                                 {"e", std::string("word")},
                                 {"f", std::string("3")},
                                 {"g", false},
                                 {"h", std::string("y")},
                                 {"i", std::numeric_limits<double>::infinity()},
                                 {"outer/inner", 4.0}};
  EXPECT_EQ(parameters, expected);
}

/// As rosparam reads its numbers.
TEST_F(ParameterFile, ListsAreTheTextThatTheyAreWrittenAs)
{
  const ParameterMap parameters =
      read_parameter_file(write("a: [0.34, -0]\nb:\n  - [1, 2e-1]\n  - [0x10, deg(180)]\nc: []\nd: '[1, 2]'\n"));
  const ParameterMap expected = {{"a", std::string("[0.34, 0]")},
                                 {"b", std::string("[[1, 0.2], [16, 3.141592653589793]]")},
                                 {"c", std::string("[]")},
                                 {"d", std::string("[1, 2]")}};
  EXPECT_EQ(parameters, expected);
}

TEST_F(ParameterFile, FootprintAndBaseOffsetMakeTheRobot)
{
  write("base_offset: [0.34, 0]\nfootprint: [[1.0, 0.4], [-0.3, 0.4], [-0.3, -0.4], [1.0, -0.4]]\n");
  const Robot robot = read_robot_file(path_);
  EXPECT_EQ(robot.base_offset.x, 0.34);
  ASSERT_EQ(robot.footprint.size(), 4u);
  EXPECT_EQ(robot.footprint[1].x, -0.3);
  write("footprint: '[[1.0, 0.4], [-1.0, 0.4], [-1.0, -0.4], [1.0, -0.4]]'\n");  // a text, as move_base takes it, too
  EXPECT_EQ(read_robot_file(path_).footprint.size(), 4u);
  write("base_offset: 0.34\n");
  EXPECT_THROW(read_robot_file(path_), ConfigError);
}

TEST_F(ParameterFile, UnusableFilesAreRejectedByNameAndLine)
{
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "holds no parameters"},
      {"just a sentence", "holds no parameters"},
      {"- 1\n- 2\n", "holds no parameters"},
      {"a: 1\nb: [1, x]\n", ":2: parameter 'b' has 'x' in its list, expected a number"},
      {"a: 1\nb: [1, true]\n", ":2: parameter 'b' has true in its list, expected a number"},
      {"a: 1\nb: [1, {c: 2}]\n", ":2: parameter 'b' holds no list of numbers"},
      {"a: &a [1, *a]\n", "lists nested deeper than 8"},
      {"a: 1\nb:\n", ":2: parameter 'b' has no value"},
      {"a: 1\nb: 2\na: 3\n", ":3: parameter 'a' appears twice"},
      {"a: 1\nb: {c: [}\n", ":2: not YAML"},
      {"a: 1\n\tb: 2\n", ":2: not YAML"},
      {"? [1, 2]\n: 3\n", ":1: a key must be a plain word"},
      {"{a: {b: {c: {d: {e: {f: {g: {h: {i: 1}}}}}}}}}\n", ":1: maps nested deeper than 8"},
  };
  for (const auto& [text, expected] : cases)
  {
    const std::string what = rejection(text);
    EXPECT_EQ(what.find(path_), 0u) << text << "\n-> " << what;
    EXPECT_TRUE(contains(what, expected)) << text << "\n-> " << what;
    EXPECT_FALSE(contains(what, "\n")) << what;
  }
}

TEST_F(ParameterFile, MissingFileAndDirectoryAreRejectedByName)
{
  for (const std::string path : {"/nowhere/robot.yaml", FOURWIS_SOURCE_DIR})
  {
    try
    {
      read_parameter_file(path);
      ADD_FAILURE() << path << " was read";
    }
    catch (const ConfigError& error)
    {
      EXPECT_EQ(std::string(error.what()).find(path), 0u) << error.what();
    }
  }
}

TEST_F(ParameterFile, RejectedContentsNameTheFile)
{
  const std::string path = write("breadth: 1.0\n");
  for (const auto& read :
       std::vector<std::function<void()>>{[&] { read_robot_file(path); }, [&] { read_planner_file(path); }})
  {
    try
    {
      read();
      ADD_FAILURE() << "was read";
    }
    catch (const ConfigError& error)
    {
      EXPECT_EQ(std::string(error.what()).find(path + ": "), 0u) << error.what();
    }
  }
}

TEST_F(ParameterFile, KeysThatAreMissingAreToldWithTheirDefaults)
{
  std::string defaults;
  const std::string path = write("length: 1.25\nwidth: 0.7\nwheelbase: 0.9\n");
  const Robot robot = read_robot_file(path, &defaults);
  EXPECT_EQ(robot.length, 1.25);
  EXPECT_EQ(robot.track_width, Robot().track_width);
  EXPECT_EQ(defaults.find(path + ": missing parameters take their defaults: "), 0u) << defaults;
  EXPECT_TRUE(contains(defaults, "track_width = 0.52")) << defaults;
  EXPECT_FALSE(contains(defaults, "length")) << defaults;

  defaults.clear();
  read_robot_file(kRobotFile, &defaults);
  EXPECT_EQ(defaults, "");
}

TEST_F(ParameterFile, ValuesThatOthersReadOtherwiseAreRejectedByNameAndLine)
{
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"a: 1\nb: 2147483648\n", ":2: parameter 'b' is 2147483648, expected a whole number of at most 31 bits, or one"},
      {"a: -0x80000001\n", ":1: parameter 'a' is -0x80000001, expected a whole number of at most 31 bits"},
      {"a: deg(pi)\n", ":1: parameter 'a' is deg(pi), expected a number of degrees"},
      {"a: rad(2**3)\n", ":1: parameter 'a' is rad(2**3), expected radians: numbers and pi"},
      {"a: rad(1/0)\n", ":1: parameter 'a' is rad(1/0), expected radians: numbers and pi"},
      {"a: !metres 30\n", ":1: parameter 'a' is 30 with the tag !metres, expected a value without a tag"},
  };
  for (const auto& [text, expected] : cases) EXPECT_TRUE(contains(rejection(text), expected)) << rejection(text);
  EXPECT_EQ(rejection("a: -2147483648\nb: 2147483647\n"), "");
}

TEST_F(ParameterFile, ShippedFilesAreReadWhole)
{
  EXPECT_EQ(read_robot_file(kRobotFile).length, Robot().length);
  EXPECT_EQ(read_planner_file(kPlannerFile).planner_patience, PlannerOptions().planner_patience);
}

}  // namespace
}  // namespace fourwis
