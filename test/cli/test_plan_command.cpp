#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../support/grids.h"
#include "cli/plan_command.h"
#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/optimize/optimize_options.h"
#include "fourwis_navigation/parameters/documentation.h"

namespace fourwis
{
namespace
{

namespace fs = std::filesystem;
using nlohmann::json;
using Words = std::vector<std::string>;

struct Outcome
{
  int status;
  std::string out, err;
};

Outcome run(Words words)
{
  words.insert(words.begin(), "plan");
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  std::ostringstream out, err;
  const int status = plan_command(static_cast<int>(argv.size()), argv.data(), out, err);
  return {status, out.str(), err.str()};
}

Words operator+(Words a, const Words& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string content_of(const std::string& path)
{
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A room of 10 m x 6 m with a wall that leaves a closed chamber on the right.
OccupancyGrid room()
{
  OccupancyGrid grid = free_grid(100, 60, 0.1);
  wall_in(grid, 1, 1, 98, 58);
  occupy_block(grid, 70, 0, 1, 60);
  return grid;
}

/// A directory with the map of the room, gone afterwards.
class PlanCommand : public testing::Test
{
protected:
  PlanCommand()
  {
    fs::create_directory(directory_);
    write_map_file(room(), path("room"));
  }
  ~PlanCommand() override { fs::remove_all(directory_); }

  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  Words across(const std::string& start, const std::string& goal) const
  {
    return {"--map", path("room.yaml"), "--start", start, "--goal", goal};
  }
  Words easy() const { return across("1.5,1.5,0", "5,4,1.5708"); }

  std::string name_ = testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path directory_ = fs::path(testing::TempDir()) / ("fourwis_plan_" + name_);
};

void expect_one_line(const std::string& text, const Words& parts)
{
  EXPECT_EQ(text.find('\n'), text.size() - 1) << text;
  for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << text << " lacks " << part;
}

TEST_F(PlanCommand, VerifiedPlanIsStatusZeroAndOnlyTheJsonIsOnTheStandardOutput)
{
  const Outcome outcome = run(easy() + Words{"--json", "-"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["status"], "succeeded");
  EXPECT_EQ(document["metrics"]["SF"], true);
  ASSERT_FALSE(document["points"].empty());
  const json& first = document["points"].front();
  const json& last = document["points"].back();
  EXPECT_NEAR(std::hypot(first["x"].get<double>() - 1.5, first["y"].get<double>() - 1.5), 0.0, 1e-3);
  EXPECT_NEAR(std::hypot(last["x"].get<double>() - 5.0, last["y"].get<double>() - 4.0), 0.0, 1e-3);
}

TEST_F(PlanCommand, WithoutJsonTheStandardOutputStaysEmpty)
{
  const Outcome outcome = run(easy() + Words{"--csv", path("plan.csv"), "--svg", path("plan.svg")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  expect_one_line(outcome.err, {"succeeded"});
}

TEST_F(PlanCommand, EveryOutputIsWritten)
{
  const Outcome outcome =
      run(easy() + Words{"--json", path("p.json"), "--csv", path("p.csv"), "--svg", path("p.svg"), "--frontend-only"});
  EXPECT_EQ(outcome.status, 0);
  const json document = json::parse(content_of(path("p.json")));
  const std::string csv = content_of(path("p.csv"));
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), document["points"].size() + 1);
  EXPECT_EQ(content_of(path("p.svg")).find("<?xml"), 0u);
}

TEST_F(PlanCommand, OnlyTheModesAskedForAreUsed)
{
  const Words straight = across("1.5,3,0", "4.5,3,0") + Words{"--json", "-"};
  const json document = json::parse(run(straight + Words{"--modes", "ackermann"}).out);
  EXPECT_EQ(document["status"], "succeeded");
  for (const json& point : document["points"]) EXPECT_EQ(point["mode"], "ackermann");
}

TEST_F(PlanCommand, FrontendOnlyIsNotOptimisedAndStopsMoreOften)
{
  const json optimised = json::parse(run(easy() + Words{"--json", "-"}).out);
  const json front_end = json::parse(run(easy() + Words{"--json", "-", "--frontend-only"}).out);
  EXPECT_GT(optimised["metrics"]["ipopt_iterations"], 0);
  EXPECT_EQ(front_end["metrics"]["ipopt_iterations"], 0);
  EXPECT_EQ(front_end["metrics"]["outer_iterations"], 0);
  EXPECT_EQ(front_end["metrics"]["SF"], true);
  EXPECT_GT(front_end["metrics"]["AT"], optimised["metrics"]["AT"]);
}

TEST_F(PlanCommand, CorridorsAreDrawnWhenAskedForAndChangeNothingElse)
{
  const Words files = {"--svg", path("p.svg"), "--csv", path("p.csv")};
  ASSERT_EQ(run(easy() + files).status, 0);
  const std::string csv = content_of(path("p.csv"));
  EXPECT_EQ(content_of(path("p.svg")).find("class=\"corridor"), std::string::npos);
  ASSERT_EQ(run(easy() + files + Words{"--corridors"}).status, 0);
  EXPECT_EQ(content_of(path("p.csv")), csv);
  for (const std::string disc : {"disc0", "disc1"})
    EXPECT_NE(content_of(path("p.svg")).find("class=\"corridor " + disc + "\" d=\"M"), std::string::npos) << disc;
}

TEST_F(PlanCommand, RepeatedPlansAreTheSamePlan)
{
  json once = json::parse(run(easy() + Words{"--json", "-"}).out);
  json often = json::parse(run(easy() + Words{"--json", "-", "--repeat", "4"}).out);
  for (json* document : {&once, &often})
    for (const char* time : {"CT_ms", "frontend_ms", "backend_ms", "verify_ms"}) (*document)["metrics"].erase(time);
  EXPECT_EQ(once, often);
}

TEST_F(PlanCommand, NoPlanIsStatusOneAndSaysWhy)
{
  const std::vector<std::pair<Words, std::string>> cases = {
      {across("0,0,0", "5,4,0"), "start_in_collision"},
      {across("-50,1,0", "5,4,0"), "start_in_collision"},
      {across("1.5,1.5,0", "7.05,4,0"), "goal_in_collision"},
      {across("1.5,1.5,0", "8.5,3,1.5708"), "goal_unreachable"},
  };
  for (const auto& [words, status] : cases)
  {
    const Outcome outcome = run(words + Words{"--json", "-", "--svg", path("why.svg")});
    EXPECT_EQ(outcome.status, 1) << status;
    expect_one_line(outcome.err, {status});
    const json document = json::parse(outcome.out);
    EXPECT_EQ(document["status"], status);
    EXPECT_NE(document["message"], "");
    EXPECT_TRUE(document["points"].empty());
    EXPECT_NE(content_of(path("why.svg")).find(status), std::string::npos);
  }
}

TEST_F(PlanCommand, UnusableInputIsStatusTwoNamedInOneLineAndInTheJson)
{
  std::ofstream(path("robot.yaml")) << "length: nine\n";
  std::ofstream(path("bad.yaml")) << "image: room.pgm\n";
  std::ofstream(path("bad.bt")) << "no tree";
  std::ofstream(path("cut.jpg")) << "\xff\xd8\xff\xe0";
  std::ofstream(path("word.png")) << "a word";
  for (const std::string image : {"cut.jpg", "word.png"})
    std::ofstream(path(image + ".yaml")) << "image: " << image
                                         << "\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\n"
                                            "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
  const Words poses = {"--start", "1.5,1.5,0", "--goal", "5,4,0"};
  const std::vector<std::pair<Words, Words>> cases = {
      {poses + Words{"--map", path("missing.yaml")}, {"missing.yaml"}},
      {poses + Words{"--map", path("bad.yaml")}, {"bad.yaml", "resolution"}},
      {poses + Words{"--map", path("cut.jpg.yaml")}, {"cut.jpg.yaml", "cut.jpg: header", "expected a complete JPEG"}},
      {poses + Words{"--map", path("word.png.yaml")}, {"word.png: format: expected a PGM", "PNG", "JPEG"}},
      {poses + Words{"--octomap", path("bad.bt")}, {"bad.bt"}},
      {easy() + Words{"--robot", path("robot.yaml")}, {"robot.yaml", "length", "nine"}},
      {easy() + Words{"--robot", path("missing.yaml")}, {"missing.yaml"}},
      {easy() + Words{"--planner", path("robot.yaml")}, {"robot.yaml", "unknown", "length", "nine"}},
      {across("1.5,nan,0", "5,4,0"), {"--start", "nan"}},
      {across("1.5,1,0", "5,4"), {"--goal", "'5,4'"}},
      {easy() + Words{"--modes", "spin"}, {"--modes", "spin"}},
      {easy() + Words{"--bogus"}, {"--bogus"}},
      {{}, {"--start"}},
  };
  for (const auto& [words, parts] : cases)
  {
    SCOPED_TRACE(testing::PrintToString(words));
    for (const std::string& json_file : {path("why.json"), std::string("-")})
    {
      const Outcome outcome = run(words + Words{"--json", json_file});
      EXPECT_EQ(outcome.status, 2);
      expect_one_line(outcome.err, parts);
      const json document = json::parse(json_file == "-" ? outcome.out : content_of(json_file));
      EXPECT_EQ(document["status"], "invalid_input");
      EXPECT_NE(outcome.err.find(document["message"].get<std::string>()), std::string::npos);
    }
    const Outcome silent = run(words);
    EXPECT_EQ(silent.status, 2);
    EXPECT_EQ(silent.out, "");
  }
}

/// A configuration file of ours with one value changed.
std::string changed(const std::string& file, const std::string& key, const std::string& value)
{
  std::istringstream lines(content_of(FOURWIS_SOURCE_DIR "/config/" + file));
  std::string text;
  for (std::string line; std::getline(lines, line); text += line + '\n')
    if (line.rfind(key + ":", 0) == 0) line = key + ": " + value;
  return text;
}

TEST_F(PlanCommand, LimitsThatAreNoneAreStatusTwoByNameValueAndRange)
{
  for (const std::string key :
       {"max_speed", "max_acceleration", "max_steering_rate", "wheel_max_rate", "wheel_max_speed"})
    for (const std::string value : {"0", "-1", ".inf", ".nan"})
    {
      std::ofstream(path("robot.yaml")) << changed("robot.yaml", key, value);
      const Outcome outcome = run(easy() + Words{"--robot", path("robot.yaml")});
      EXPECT_EQ(outcome.status, 2) << key << " " << value;
      expect_one_line(outcome.err, {"robot.yaml", key, "expected a number from"});
    }
}

TEST_F(PlanCommand, AnOlderFileGoesOnWorkingAndWhatItLacksIsTold)
{
  std::ofstream(path("old robot.yaml")) << "length: 8e-1\nmax_steering_angle: deg(25)\n";
  const Outcome outcome = run(easy() + Words{"--robot", path("old robot.yaml")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(
      outcome.err.find("plan: " + path("old robot.yaml") + ": missing parameters take their defaults: width = 0.62"),
      0u)
      << outcome.err;
  EXPECT_NE(outcome.err.find("\nplan: succeeded"), std::string::npos) << outcome.err;
}

TEST_F(PlanCommand, UnseenCellsThatBecomeFreeAreToldAndPlannedThrough)
{
  OccupancyGrid unseen = room();
  occupy_block(unseen, 40, 20, 10, 10);
  for (std::int8_t& cell : unseen.data)
    if (cell == 0) cell = -1;
  write_map_file(unseen, path("room"));
  std::string yaml = content_of(path("room.yaml"));
  yaml.replace(yaml.find("0.196"), 5, "0.25");
  std::ofstream(path("nav2.yaml")) << yaml << "mode: trinary\n";
  const Words poses = {"--start", "1.5,1.5,0", "--goal", "3,4,0"};
  const Outcome outcome = run(poses + Words{"--map", path("nav2.yaml")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto unseen_cells = std::count(unseen.data.begin(), unseen.data.end(), -1);
  EXPECT_EQ(outcome.err.find("plan: warning: " + path("nav2.yaml") + ": free_thresh is 0.25, "), 0u) << outcome.err;
  EXPECT_NE(outcome.err.find("free: " + std::to_string(unseen_cells) + " of 6000 pixels"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(run(poses + Words{"--map", path("room.yaml")}).status, 1);
}

TEST_F(PlanCommand, PathsMayLieAtHomeAndHaveSpaces)
{
  const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
  const std::string folder = path("at home");
  fs::create_directory(folder);
  write_map_file(room(), folder + "/my room");
  fs::copy_file(FOURWIS_SOURCE_DIR "/config/robot.yaml", folder + "/my robot.yaml");
  fs::copy_file(FOURWIS_SOURCE_DIR "/config/planner.yaml", folder + "/my planner.yaml");
  setenv("HOME", folder.c_str(), 1);
  const Outcome outcome = run({"--map", "~/my room.yaml", "--robot", "~/my robot.yaml", "--planner",
                               "~/my planner.yaml", "--start", "1.5,1.5,0", "--goal", "5,4,1.5708", "--svg",
                               "~/my plan.svg", "--csv", "~/my plan.csv", "--json=~/my plan.json"});
  const Outcome refused = run({"--map", "~/my room.yaml", "--json", "~/why.json"});
  setenv("HOME", home.c_str(), 1);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* file : {"/my plan.svg", "/my plan.csv", "/my plan.json", "/why.json"})
    EXPECT_TRUE(fs::exists(folder + file)) << file;
  EXPECT_EQ(refused.status, 2);
}

TEST_F(PlanCommand, AMillimetreIsPlanned)
{
  for (const std::string goal : {"1.501,1.5,0", "1.5,1.501,0", "1.5,1.5,0.001", "1.5,1.5,0"})
  {
    const Outcome outcome = run(across("1.5,1.5,0", goal));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
}

TEST_F(PlanCommand, ThePapersFormulationNeedsIpoptAndIsRefusedByTheReferee)
{
  std::ofstream(path("paper.yaml")) << changed("planner.yaml", "formulation", "paper");
  const Words paper = {"--planner", path("paper.yaml"), "--modes", "ackermann", "--json", "-"};
  const Outcome alone = run(easy() + paper);
  EXPECT_EQ(alone.status, 2);
  if (!has_ipopt())
  {
    expect_one_line(alone.err, {"paper.yaml: ", "'formulation' is 'paper'", "built without Ipopt"});
    return;
  }
  expect_one_line(alone.err,
                  {"paper.yaml: ", "'solver' is 'structured'", "expected 'ipopt' where 'formulation' is 'paper'"});

  std::string text = content_of(path("paper.yaml"));
  text.replace(text.find("solver: structured"), 18, "solver: ipopt");
  std::ofstream(path("paper.yaml")) << text;
  const Outcome outcome = run(easy() + paper);
  EXPECT_EQ(outcome.status, 1);
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["status"], "verification_failed");
  EXPECT_NE(document["message"].get<std::string>().find("limit"), std::string::npos) << document["message"];
  EXPECT_TRUE(document["points"].empty());
}

TEST_F(PlanCommand, OutputThatCannotBeWrittenIsStatusTwoByNameAndLeavesNothing)
{
  for (const std::string option : {"--json", "--csv", "--svg"})
  {
    const std::string file = path("missing/plan");
    const Outcome outcome = run(easy() + Words{option, file});
    EXPECT_EQ(outcome.status, 2);
    expect_one_line(outcome.err, {file});
  }
  const Outcome outcome = run(easy() + Words{"--csv", path("p.csv"), "--svg", path("missing/p.svg"), "--json", "-"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(json::parse(outcome.out)["status"], "invalid_input");
  EXPECT_FALSE(fs::exists(path("p.csv")));
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_), {}), 2) << "room.yaml and room.pgm";
}

TEST_F(PlanCommand, HelpIsStatusZero)
{
  const Outcome outcome = run({"--help"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("--octomap"), std::string::npos);
  EXPECT_EQ(outcome.err, "");
}

TEST_F(PlanCommand, ParametersAreListedWithStatusZero)
{
  const Outcome outcome = run({"--list-parameters"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, parameter_documentation());
  EXPECT_EQ(outcome.err, "");
}

TEST_F(PlanCommand, ShippedConfigurationPlansLikeTheDefaults)
{
  const std::string config = FOURWIS_SOURCE_DIR "/config/";
  const Words files = {"--robot", config + "robot.yaml", "--planner", config + "planner.yaml"};
  const json with_files = json::parse(run(easy() + files + Words{"--json", "-"}).out);
  const json defaults = json::parse(run(easy() + Words{"--json", "-"}).out);
  EXPECT_EQ(with_files["points"], defaults["points"]);
  EXPECT_EQ(with_files["status"], "succeeded");
}

}  // namespace
}  // namespace fourwis
