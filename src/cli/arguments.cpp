#include "fourwis_navigation/cli/arguments.h"

#include <cmath>
#include <locale>
#include <optional>
#include <sstream>
#include <vector>

#include <CLI/CLI.hpp>

namespace fourwis
{
namespace
{

/// The options whose values CLI11 hands over as the user typed them; we convert them ourselves because its numbers
/// include nan and inf.
struct RawOptions
{
  std::string start, goal, modes, height_min, height_max;
};

const char* const kFooter =
  "\nExit status: 0 a verified plan; 1 no plan (the JSON says why); 2 unusable input.\n"
  "Example: plan --map config/env4.yaml --start 1,2,0 --goal 8,3,1.57 --svg plan.svg";

std::vector<std::string> split(const std::string& text)
{
  std::vector<std::string> words(1);
  for (const char c : text)
  {
    if (c == ',')
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

/// A finite decimal number and nothing else.
std::optional<double> number_in(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  stream >> std::noskipws >> number;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof() || !std::isfinite(number))
    return std::nullopt;
  return number;
}

[[noreturn]] void refuse(const std::string& option, const std::string& value, const std::string& expected)
{
  throw CLI::ValidationError(option, "'" + value + "' is not understood, expected " + expected);
}

Pose pose_in(const std::string& option, const std::string& text)
{
  const char* const expected = "X,Y,YAW: three finite numbers in metres and radians";
  const std::vector<std::string> words = split(text);
  if (words.size() != 3) refuse(option, text, expected);
  double numbers[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::optional<double> number = number_in(words[i]);
    if (!number) refuse(option, text, expected);
    numbers[i] = *number;
  }
  return {numbers[0], numbers[1], numbers[2]};
}

double height_in(const std::string& option, const std::string& text)
{
  const std::optional<double> number = number_in(text);
  if (!number) refuse(option, text, "a finite number in metres");
  return *number;
}

ModeSet modes_in(const std::string& text)
{
  ModeSet modes = ModeSet::none();
  for (const std::string& word : split(text))
  {
    const std::optional<Mode> mode = mode_from_string(word);
    if (!mode) refuse("--modes", text, "a comma-separated list of ackermann, lateral, parallel");
    modes.insert(*mode);
  }
  return modes;
}

void add_options(CLI::App& app, PlanArguments& arguments, RawOptions& raw)
{
  app.add_option("--map", arguments.map, "map in map_server's format: YAML beside a PGM or PNG image");
  CLI::Option* octomap = app.add_option("--octomap", arguments.octomap, "3D map (.bt or .ot) instead of --map");
  app.add_option("--height-min", raw.height_min, "lowest height of the 3D map that matters [m], default 0.1")
    ->needs(octomap);
  app.add_option("--height-max", raw.height_max, "greatest height of the 3D map that matters [m], default 1.0")
    ->needs(octomap);
  app.add_option("--start", raw.start, "X,Y,YAW in the map frame [m, m, rad]")->required();
  app.add_option("--goal", raw.goal, "X,Y,YAW in the map frame [m, m, rad]")->required();
  app.add_option("--robot", arguments.robot, "robot.yaml; default: the values of config/robot.yaml");
  app.add_option("--planner", arguments.planner, "planner.yaml; default: the values of config/planner.yaml");
  app.add_option("--modes", raw.modes, "modes to plan in, default ackermann,lateral,parallel");
  app.add_flag("--frontend-only", arguments.frontend_only, "stop after the front end's own trajectory");
  app.add_option("--repeat", arguments.repeat, "plan N times and report the medians of the times")
    ->check(CLI::Range(1, 100000));
  app.add_option("--json", arguments.json, "write status, metrics and trajectory; - is the standard output");
  app.add_option("--csv", arguments.csv, "write the trajectory's points");
  app.add_option("--svg", arguments.svg, "draw map, footprints and path");
}

/// What CLI11 does not check.
void convert(const CLI::App& app, const RawOptions& raw, PlanArguments& arguments)
{
  if (arguments.map.empty() == arguments.octomap.empty())
    throw CLI::RequiredError("exactly one of --map MAP.yaml and --octomap FILE.bt");
  arguments.start = pose_in("--start", raw.start);
  arguments.goal = pose_in("--goal", raw.goal);
  if (app.count("--modes") > 0) arguments.modes = modes_in(raw.modes);
  if (app.count("--height-min") > 0) arguments.band.min = height_in("--height-min", raw.height_min);
  if (app.count("--height-max") > 0) arguments.band.max = height_in("--height-max", raw.height_max);
  if (!(arguments.band.min < arguments.band.max))
    throw CLI::ValidationError("--height-max", "expected to be greater than --height-min");
  if (arguments.csv == "-") refuse("--csv", "-", "a file: only --json writes to the standard output");
  if (arguments.svg == "-") refuse("--svg", "-", "a file: only --json writes to the standard output");
}

/// Where the JSON shall go, whatever is wrong with the other arguments.
std::string json_file_in(int argc, const char* const* argv)
{
  const std::string option = "--json";
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == option && i + 1 < argc) return argv[i + 1];
    if (word.compare(0, option.size() + 1, option + "=") == 0) return word.substr(option.size() + 1);
  }
  return "";
}

}  // namespace

PlanArguments parse_arguments(int argc, const char* const* argv)
{
  PlanArguments arguments;
  RawOptions raw;
  CLI::App app("Plans a verified multi-modal trajectory of a 4WIS robot on a map.", "plan");
  app.footer(kFooter);
  add_options(app, arguments, raw);
  try
  {
    app.parse(argc, argv);
    convert(app, raw, arguments);
  }
  catch (const CLI::CallForHelp&)
  {
    arguments.help = app.help();
  }
  catch (const CLI::Error& error)
  {
    throw UsageError(error.what(), json_file_in(argc, argv));
  }
  return arguments;
}

}  // namespace fourwis
