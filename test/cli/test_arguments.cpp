#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/arguments.h"

namespace fourwis
{
namespace
{

using Words = std::vector<std::string>;

PlanArguments parse(Words words)
{
  words.insert(words.begin(), "plan");
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  return parse_arguments(static_cast<int>(argv.size()), argv.data());
}

/// The least that is accepted, and `more`.
Words valid(const Words& more = {})
{
  Words words = {"--map", "map.yaml", "--start", "1,2,3", "--goal", "4,5,6"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// `words` must be refused in one line that contains all of `parts`.
void expect_rejection(const Words& words, const Words& parts)
{
  try
  {
    parse(words);
    ADD_FAILURE() << "accepted: " << testing::PrintToString(words);
  }
  catch (const UsageError& error)
  {
    const std::string what = error.what();
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    for (const std::string& part : parts) EXPECT_NE(what.find(part), std::string::npos) << what << "\n lacks " << part;
  }
}

TEST(Arguments, DefaultsAreAllModesOnePlanAndNoOutput)
{
  const PlanArguments arguments = parse(valid());
  EXPECT_EQ(arguments.text, "");
  EXPECT_EQ(arguments.map, "map.yaml");
  EXPECT_EQ(arguments.start.x, 1.0);
  EXPECT_EQ(arguments.start.y, 2.0);
  EXPECT_EQ(arguments.start.theta, 3.0);
  EXPECT_EQ(arguments.goal.x, 4.0);
  EXPECT_EQ(arguments.goal.y, 5.0);
  EXPECT_EQ(arguments.goal.theta, 6.0);
  EXPECT_TRUE(arguments.modes == (ModeSet{Mode::ackermann, Mode::lateral, Mode::parallel}));
  EXPECT_FALSE(arguments.frontend_only);
  EXPECT_FALSE(arguments.corridors);
  EXPECT_FALSE(arguments.iterations);
  EXPECT_EQ(arguments.repeat, 1);
  for (const std::string& file :
       {arguments.octomap, arguments.robot, arguments.planner, arguments.json, arguments.csv, arguments.svg})
    EXPECT_EQ(file, "");
}

TEST(Arguments, EveryOptionIsRead)
{
  const PlanArguments arguments = parse({"--octomap",
                                         "building.bt",
                                         "--height-min",
                                         "-0.25",
                                         "--height-max",
                                         "2e0",
                                         "--start=-1,-2.5,1e-3",
                                         "--goal",
                                         "-4,5,-6",
                                         "--robot",
                                         "r.yaml",
                                         "--planner",
                                         "p.yaml",
                                         "--modes",
                                         "lateral,parallel",
                                         "--frontend-only",
                                         "--repeat",
                                         "20",
                                         "--json",
                                         "-",
                                         "--csv",
                                         "c.csv",
                                         "--svg",
                                         "s.svg",
                                         "--corridors",
                                         "--iterations"});
  EXPECT_EQ(arguments.map, "");
  EXPECT_EQ(arguments.octomap, "building.bt");
  EXPECT_EQ(arguments.band.min, -0.25);
  EXPECT_EQ(arguments.band.max, 2.0);
  EXPECT_EQ(arguments.start.x, -1.0);
  EXPECT_EQ(arguments.start.theta, 1e-3);
  EXPECT_EQ(arguments.goal.x, -4.0);
  EXPECT_EQ(arguments.robot, "r.yaml");
  EXPECT_EQ(arguments.planner, "p.yaml");
  EXPECT_TRUE(arguments.modes == (ModeSet{Mode::lateral, Mode::parallel}));
  EXPECT_TRUE(arguments.frontend_only);
  EXPECT_TRUE(arguments.corridors);
  EXPECT_TRUE(arguments.iterations);
  EXPECT_EQ(arguments.repeat, 20);
  EXPECT_EQ(arguments.json, "-");
  EXPECT_EQ(arguments.csv, "c.csv");
  EXPECT_EQ(arguments.svg, "s.svg");
}

TEST(Arguments, MalformedPosesAreRejectedByOptionAndValue)
{
  for (const std::string option : {"--start", "--goal"})
    for (const std::string pose : {"nan,0,0", "0,inf,0", "0,0,-inf", "1,2", "1,2,3,4", "1,2,", ",1,2", "a,b,c",
                                   "1,2,3x", "1;2;3", " 1,2,3", "1, 2,3", "1,2,3 ", "0x1p3,0,0", "1e999,0,0", "", ",,"})
    {
      SCOPED_TRACE(option + " '" + pose + "'");
      const std::string other = option == "--start" ? "--goal" : "--start";
      expect_rejection({"--map", "m", other, "0,0,0", option + "=" + pose}, {option});
      if (pose.empty()) continue;
      expect_rejection({"--map", "m", other, "0,0,0", option, pose}, {option, "'" + pose + "'", "X,Y,YAW"});
    }
}

TEST(Arguments, UnknownModesAreRejectedByName)
{
  for (const std::string modes : {"spin", "none", "Ackermann", "ackermann,", ",lateral", "ackermann,sideways",
                                  "ackermann lateral", "ackermann, lateral"})
    expect_rejection(valid({"--modes", modes}), {"--modes", "'" + modes + "'", "ackermann, lateral, parallel"});
}

TEST(Arguments, EachPlannedModeCanBeAskedForAlone)
{
  for (const Mode mode : kPlannedModes)
  {
    const ModeSet modes = parse(valid({"--modes", to_string(mode)})).modes;
    for (const Mode other : kPlannedModes) EXPECT_EQ(modes.contains(other), other == mode) << to_string(mode);
  }
}

TEST(Arguments, ExactlyOneMapIsNeeded)
{
  expect_rejection({"--start", "0,0,0", "--goal", "0,0,0"}, {"--map", "--octomap", "exactly one"});
  expect_rejection(valid({"--octomap", "b.bt"}), {"--map", "--octomap", "exactly one"});
}

TEST(Arguments, StartAndGoalAreNeededOnce)
{
  expect_rejection({"--map", "m", "--goal", "0,0,0"}, {"--start"});
  expect_rejection({"--map", "m", "--start", "0,0,0"}, {"--goal"});
  expect_rejection({"--map", "m", "--start", "0,0,0", "--goal"}, {"--goal"});
  expect_rejection(valid({"--start", "0,0,0"}), {"--start"});
}

TEST(Arguments, HeightsBelongToAnOctomapAndAreInOrder)
{
  const Words octomap = {"--octomap", "b", "--start", "0,0,0", "--goal", "0,0,0"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), octomap.begin(), octomap.end());
    return more;
  };
  expect_rejection(valid({"--height-min", "0.2"}), {"--height-min", "--octomap"});
  expect_rejection(valid({"--corridors"}), {"--corridors", "--svg"});
  expect_rejection(valid({"--iterations"}), {"--iterations", "--svg"});
  expect_rejection(valid({"--height-max", "0.2"}), {"--height-max", "--octomap"});
  expect_rejection(with({"--height-min", "nan"}), {"--height-min", "'nan'"});
  expect_rejection(with({"--height-max", "high"}), {"--height-max", "'high'"});
  expect_rejection(with({"--height-min", "1", "--height-max", "1"}), {"--height-max", "--height-min"});
  EXPECT_EQ(parse(with({"--height-max", "3"})).band.max, 3.0);
  EXPECT_EQ(parse(with({"--height-max", "3"})).band.min, HeightBand().min);
}

TEST(Arguments, RepeatIsAPositiveWholeNumber)
{
  for (const std::string count : {"0", "-1", "1.5", "many", "1e3", "99999999999"})
    expect_rejection(valid({"--repeat", count}), {"--repeat"});
}

TEST(Arguments, OnlyTheJsonGoesToTheStandardOutput)
{
  for (const std::string option : {"--csv", "--svg"})
    expect_rejection(valid({option, "-"}), {option, "standard output"});
}

TEST(Arguments, UnknownArgumentsAreRejectedByName)
{
  expect_rejection(valid({"--bogus", "1"}), {"--bogus"});
  expect_rejection(valid({"stray"}), {"stray"});
}

TEST(Arguments, RejectionsKnowWhereTheJsonShallGo)
{
  for (const Words& words : {Words{"--json", "a.json"}, Words{"--json=a.json", "--start"},
                             valid({"--x", "--json=a.json"}), valid({"--modes", "spin", "--json", "a.json"})})
  {
    try
    {
      parse(words);
      ADD_FAILURE() << "accepted: " << testing::PrintToString(words);
    }
    catch (const UsageError& error)
    {
      EXPECT_EQ(error.json, "a.json") << testing::PrintToString(words);
    }
  }
}

TEST(Arguments, HelpNamesEveryOptionAndNeedsNothingElse)
{
  for (const std::string ask : {"--help", "-h"})
  {
    const std::string help = parse({ask}).text;
    for (const std::string option : {"--map", "--octomap", "--height-min", "--height-max", "--start", "--goal",
                                     "--robot", "--planner", "--modes", "--frontend-only", "--repeat", "--json",
                                     "--csv", "--svg", "--corridors", "--iterations", "--list-parameters"})
      EXPECT_NE(help.find(option), std::string::npos) << option;
  }
}

}  // namespace
}  // namespace fourwis
