#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{
namespace
{

const std::string kRobotFile = FOURWIS_SOURCE_DIR "/config/robot.yaml";
const std::string kPlannerFile = FOURWIS_SOURCE_DIR "/config/planner.yaml";

/// A key and the member that it must set, as a number.
template <class Options>
struct Binding
{
  std::string key;
  std::function<double(const Options&)> get;
};

/// A configuration file, what reads it, and where its keys go.
template <class Options>
struct Subject
{
  std::string file;
  Options (*read)(const ParameterMap&);
  std::vector<Binding<Options>> bindings;
};

Subject<Robot> robot_subject()
{
  return {kRobotFile,
          robot_from,
          {{"length", [](const Robot& r) { return r.length; }},
           {"width", [](const Robot& r) { return r.width; }},
           {"wheelbase", [](const Robot& r) { return r.wheelbase; }},
           {"track_width", [](const Robot& r) { return r.track_width; }},
           {"max_steering_angle", [](const Robot& r) { return r.max_steering_angle; }},
           {"max_steering_rate", [](const Robot& r) { return r.max_steering_rate; }},
           {"max_speed", [](const Robot& r) { return r.max_speed; }},
           {"max_acceleration", [](const Robot& r) { return r.max_acceleration; }},
           {"mode_switch_time", [](const Robot& r) { return r.mode_switch_time; }},
           {"wheel_max_angle", [](const Robot& r) { return r.wheel_max_angle; }},
           {"wheel_max_rate", [](const Robot& r) { return r.wheel_max_rate; }},
           {"wheel_max_speed", [](const Robot& r) { return r.wheel_max_speed; }},
           {"safety_margin", [](const Robot& r) { return r.safety_margin; }}}};
}

Subject<PlannerOptions> planner_subject()
{
  using O = PlannerOptions;
  return {kPlannerFile,
          planner_options_from,
          {{"occupied_threshold", [](const O& o) { return double(o.obstacles.occupied_threshold); }},
           {"unknown_is_obstacle", [](const O& o) { return double(o.obstacles.unknown_is_obstacle); }},
           {"reference_speed", [](const O& o) { return o.search.reference_speed; }},
           {"step_time", [](const O& o) { return o.search.step_time; }},
           {"reverse_penalty", [](const O& o) { return o.search.reverse_penalty; }},
           {"lateral_reverse_penalty", [](const O& o) { return o.search.lateral_reverse_penalty; }},
           {"steering_penalty", [](const O& o) { return o.search.steering_penalty; }},
           {"parallel_steering_penalty", [](const O& o) { return o.search.parallel_steering_penalty; }},
           {"steering_change_penalty", [](const O& o) { return o.search.steering_change_penalty; }},
           {"direction_change_penalty", [](const O& o) { return o.search.direction_change_penalty; }},
           {"heuristic_weight", [](const O& o) { return o.search.heuristic_weight; }},
           {"terminal_connection", [](const O& o) { return double(o.search.terminal_connection); }},
           {"switching_awareness", [](const O& o) { return double(o.search.switching_awareness); }},
           {"xy_resolution", [](const O& o) { return o.search.xy_resolution; }},
           {"heading_resolution", [](const O& o) { return o.search.heading_resolution; }},
           {"xy_goal_tolerance", [](const O& o) { return o.search.xy_goal_tolerance; }},
           {"yaw_goal_tolerance", [](const O& o) { return o.search.yaw_goal_tolerance; }},
           {"knot_spacing", [](const O& o) { return o.optimize.spacing; }},
           {"steering_comfort", [](const O& o) { return o.optimize.steering_comfort; }},
           {"interval_weight", [](const O& o) { return o.optimize.interval_weight; }},
           {"corridor_weight", [](const O& o) { return o.optimize.corridor_weight; }},
           {"shortest_interval", [](const O& o) { return o.optimize.shortest_interval; }},
           {"longest_interval", [](const O& o) { return o.optimize.longest_interval; }},
           {"longest_at_rest", [](const O& o) { return o.optimize.longest_at_rest; }},
           {"corridor_discs", [](const O& o) { return o.optimize.corridor_discs; }},
           {"polish_discs", [](const O& o) { return o.optimize.polish_discs; }},
           {"corridor_range", [](const O& o) { return o.optimize.corridor_range; }},
           {"outer_iterations", [](const O& o) { return double(o.optimize.outer_iterations); }},
           {"repairs", [](const O& o) { return double(o.optimize.repairs); }},
           {"shortcut_passes", [](const O& o) { return double(o.search.shortcut_passes); }},
           {"max_expansions", [](const O& o) { return double(o.search.max_expansions); }},
           {"collision_step", [](const O& o) { return o.verify.collision_step; }},
           {"planner_patience", [](const O& o) { return o.planner_patience; }}}};
}

/// What `read` says against `parameters`; empty when it accepts them.
template <class Options>
std::string complaint(Options (*read)(const ParameterMap&), const ParameterMap& parameters)
{
  try
  {
    read(parameters);
  }
  catch (const ConfigError& error)
  {
    return error.what();
  }
  return "";
}

ParameterMap with(ParameterMap parameters, const std::string& key, const ParameterValue& value)
{
  parameters[key] = value;
  return parameters;
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// A value the key does not have in the shipped file but could.
ParameterValue another(const ParameterValue& value)
{
  if (const bool* flag = std::get_if<bool>(&value)) return !*flag;
  const double number = std::get<double>(value);
  if (number == 0.0) return 0.5;
  return number > 1.0 && number == std::floor(number) ? number - 1.0 : number * 0.999;
}

/// Runs `law` on both configuration files.
#define FOR_BOTH_FILES(law)              \
  {                                      \
    SCOPED_TRACE("robot.yaml");          \
    law(robot_subject());                \
  }                                      \
  {                                      \
    SCOPED_TRACE("planner.yaml");        \
    law(planner_subject());              \
  }

template <class Options>
void shipped_file_equals_defaults(const Subject<Options>& subject)
{
  const ParameterMap parameters = read_parameter_file(subject.file);
  EXPECT_EQ(parameters.size(), subject.bindings.size());
  const Options shipped = subject.read(parameters), defaults;
  for (const auto& [key, get] : subject.bindings)
  {
    EXPECT_EQ(parameters.count(key), 1u) << key;
    EXPECT_EQ(get(shipped), get(defaults)) << key;
  }
}
TEST(Parameters, ShippedFilesHoldEveryKeyAndEqualTheDefaults) { FOR_BOTH_FILES(shipped_file_equals_defaults) }

template <class Options>
void each_key_sets_its_own_member(const Subject<Options>& subject)
{
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const auto& [changed, unused] : subject.bindings)
  {
    const Options options = subject.read(with(shipped, changed, another(shipped.at(changed))));
    const Options defaults;
    for (const auto& [key, get] : subject.bindings)
      EXPECT_EQ(get(options) != get(defaults), key == changed) << changed << " changed, looking at " << key;
  }
}
TEST(Parameters, EachKeySetsItsOwnMemberAndNoOther) { FOR_BOTH_FILES(each_key_sets_its_own_member) }

template <class Options>
void missing_key_is_refused(const Subject<Options>& subject)
{
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const auto& [key, value] : shipped)
  {
    ParameterMap parameters = shipped;
    parameters.erase(key);
    EXPECT_EQ(complaint(subject.read, parameters), "missing parameter " + key);
  }
}
TEST(Parameters, EachMissingKeyIsRefusedByName) { FOR_BOTH_FILES(missing_key_is_refused) }

template <class Options>
void unknown_key_is_refused(const Subject<Options>& subject)
{
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const std::string key : {"wheel_base", "", "search/step_time"})
  {
    const std::string text = complaint(subject.read, with(shipped, key, 0.25));
    EXPECT_TRUE(contains(text, "'" + key + "'")) << text;
    EXPECT_TRUE(contains(text, "0.25")) << text;
    for (const auto& [known, value] : shipped) EXPECT_TRUE(contains(text, known)) << text;
  }
}
TEST(Parameters, UnknownKeyIsRefusedByNameAndTheKnownOnesAreListed) { FOR_BOTH_FILES(unknown_key_is_refused) }

template <class Options>
void number_out_of_range_is_refused(const Subject<Options>& subject)
{
  const double inf = std::numeric_limits<double>::infinity();
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const auto& [key, value] : shipped)
  {
    if (!std::holds_alternative<double>(value)) continue;
    double min = NAN, max = NAN;
    for (const double bad : {-1e12, 1e12, inf, -inf, std::nan("")})
    {
      const std::string text = complaint(subject.read, with(shipped, key, bad));
      std::ostringstream number;
      number << bad;
      EXPECT_TRUE(contains(text, "'" + key + "' is " + number.str() + ", expected a")) << text;
      ASSERT_TRUE(contains(text, " from ")) << text;
      ASSERT_EQ(std::sscanf(text.c_str() + text.find(" from "), " from %lf to %lf", &min, &max), 2) << text;
    }
    const double step = 1e-6 * std::max(1.0, max);
    EXPECT_NE(complaint(subject.read, with(shipped, key, min - 1e-6)), "") << key;
    EXPECT_NE(complaint(subject.read, with(shipped, key, max + step)), "") << key;
    EXPECT_EQ(complaint(subject.read, with(shipped, key, value)), "") << key;
  }
}
TEST(Parameters, NumberOutsideTheRangeIsRefusedByNameValueAndRange)
{
  FOR_BOTH_FILES(number_out_of_range_is_refused)
}

template <class Options>
void wrong_type_is_refused(const Subject<Options>& subject)
{
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const auto& [key, value] : shipped)
  {
    const bool flag = std::holds_alternative<bool>(value);
    const std::string swapped = complaint(subject.read, with(shipped, key, flag ? ParameterValue(1.0) : true));
    EXPECT_TRUE(contains(swapped, "'" + key + (flag ? "' is 1, expected true or false" : "' is true, expected a ")))
        << swapped;
    const std::string word = complaint(subject.read, with(shipped, key, std::string("fast")));
    EXPECT_TRUE(contains(word, "'" + key + "' is 'fast', expected ")) << word;
  }
}
TEST(Parameters, WrongTypeIsRefusedByNameAndValue) { FOR_BOTH_FILES(wrong_type_is_refused) }

TEST(Parameters, FractionIsRefusedWhereAWholeNumberIsExpected)
{
  const ParameterMap shipped = read_parameter_file(kPlannerFile);
  for (const std::string key : {"occupied_threshold", "shortcut_passes", "max_expansions"})
  {
    const std::string text = complaint(planner_options_from, with(shipped, key, 50.5));
    EXPECT_TRUE(contains(text, "'" + key + "' is 50.5, expected a whole number from ")) << text;
  }
}

TEST(Parameters, RangeEndsAreAllowed)
{
  const ParameterMap robot = read_parameter_file(kRobotFile), planner = read_parameter_file(kPlannerFile);
  EXPECT_EQ(robot_from(with(robot, "mode_switch_time", 0.0)).mode_switch_time, 0.0);
  EXPECT_EQ(robot_from(with(robot, "max_steering_angle", M_PI * 80 / 180)).max_steering_angle, M_PI * 80 / 180);
  EXPECT_EQ(planner_options_from(with(planner, "occupied_threshold", 1.0)).obstacles.occupied_threshold, 1);
  EXPECT_EQ(planner_options_from(with(planner, "occupied_threshold", 100.0)).obstacles.occupied_threshold, 100);
}

TEST(Parameters, WheelsOutsideTheBodyAreRefused)
{
  const ParameterMap shipped = read_parameter_file(kRobotFile);
  for (const auto& [axis, side] : {std::pair("wheelbase", "length"), std::pair("track_width", "width")})
  {
    const double extent = std::get<double>(shipped.at(side));
    EXPECT_EQ(complaint(robot_from, with(shipped, axis, extent)), "");
    const std::string text = complaint(robot_from, with(shipped, axis, extent + 0.01));
    EXPECT_TRUE(contains(text, axis) && contains(text, side)) << text;
  }
}

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
  std::string refusal(const std::string& text)
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

TEST_F(ParameterFile, UnusableFilesAreRefusedByNameAndLine)
{
  const std::vector<std::pair<std::string, std::string>> cases = {
    {"", "holds no parameters"},
    {"just a sentence", "holds no parameters"},
    {"- 1\n- 2\n", "holds no parameters"},
    {"a: 1\nb: [1, 2]\n", ":2: parameter 'b' has no single value"},
    {"a: 1\nb:\n", ":2: parameter 'b' has no single value"},
    {"a: 1\nb: 2\na: 3\n", ":3: parameter 'a' appears twice"},
    {"a: 1\nb: {c: [}\n", ":2: not YAML"},
    {"a: 1\n\tb: 2\n", ":2: not YAML"},
    {"? [1, 2]\n: 3\n", ":1: a key must be a plain word"},
    {"{a: {b: {c: {d: {e: {f: {g: {h: {i: 1}}}}}}}}}\n", ":1: maps nested deeper than 8"},
  };
  for (const auto& [text, expected] : cases)
  {
    const std::string what = refusal(text);
    EXPECT_EQ(what.find(path_), 0u) << text << "\n-> " << what;
    EXPECT_TRUE(contains(what, expected)) << text << "\n-> " << what;
    EXPECT_FALSE(contains(what, "\n")) << what;
  }
}

TEST_F(ParameterFile, MissingFileAndDirectoryAreRefusedByName)
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

TEST_F(ParameterFile, RefusedContentsNameTheFile)
{
  const std::string path = write("length: 1.0\n");
  for (const auto& read : std::vector<std::function<void()>>{[&] { read_robot_file(path); },
                                                              [&] { read_planner_file(path); }})
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

TEST_F(ParameterFile, ShippedFilesAreReadWhole)
{
  EXPECT_EQ(read_robot_file(kRobotFile).length, Robot().length);
  EXPECT_EQ(read_planner_file(kPlannerFile).planner_patience, PlannerOptions().planner_patience);
}

}  // namespace
}  // namespace fourwis
