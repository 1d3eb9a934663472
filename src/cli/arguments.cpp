#include "arguments.h"

#include <cmath>
#include <locale>
#include <optional>
#include <sstream>
#include <vector>

#include <boost/program_options.hpp>

#include "fourwis_navigation/model/home_path.h"
#include "fourwis_navigation/model/sentence.h"
#include "fourwis_navigation/parameters/documentation.h"

namespace po = boost::program_options;

namespace fourwis
{
namespace
{

const char* const kFooter =
    "\nExit status: 0 a verified plan; 1 no plan (the JSON says why); 2 unusable input.\n"
    "Example: plan --map config/env4.yaml --start 1.1,1.1,1.57 --goal 10.65,8.75,3.14 --svg plan.svg";

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

[[noreturn]] void reject_value(const std::string& option, const std::string& value, const std::string& expected)
{
  reject<po::error>(option, ": '", value, "' is not understood, expected ", expected);
}

Pose pose_in(const std::string& option, const std::string& text)
{
  const char* const expected = "X,Y,YAW: three finite numbers in metres and radians";
  const std::vector<std::string> words = split(text);
  if (words.size() != 3) reject_value(option, text, expected);
  double numbers[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::optional<double> number = number_in(words[i]);
    if (!number) reject_value(option, text, expected);
    numbers[i] = *number;
  }
  return {numbers[0], numbers[1], numbers[2]};
}

double height_in(const std::string& option, const std::string& text)
{
  const std::optional<double> number = number_in(text);
  if (!number) reject_value(option, text, "a finite number in metres");
  return *number;
}

ModeSet modes_in(const std::string& text)
{
  ModeSet modes = ModeSet::none();
  for (const std::string& word : split(text))
  {
    const std::optional<Mode> mode = mode_from_string(word);
    if (!mode) reject_value("--modes", text, "a comma-separated list of " + planned_mode_names(", ", ", "));
    modes.insert(*mode);
  }
  return modes;
}

int repetitions_in(const std::string& text)
{
  const std::optional<double> number = number_in(text);
  if (!number || *number < 1.0 || *number > 100000.0 || text.find_first_not_of("0123456789") != std::string::npos)
    reject_value("--repeat", text, "a whole number from 1 to 100000");
  return static_cast<int>(*number);
}

/// Values are taken as the user typed them and converted by us: a pose is no type of the library, and its numbers
/// include nan and inf.
po::options_description known_options()
{
  const auto value = [](const char* name) { return po::value<std::string>()->value_name(name); };
  po::options_description options("Options");
  options.add_options()("help,h", "print this text")(
      "list-parameters", "print key, default, range and unit of every parameter of every configuration file")(
      "map", value("FILE"), "map in map_server's format: YAML beside a PGM, PNG, JPEG, BMP or TIFF image")(
      "octomap", value("FILE"), "3D map (.bt or .ot) instead of --map")(
      "height-min", value("Z"), "lowest height of the 3D map that matters [m], default 0.1")(
      "height-max", value("Z"), "greatest height of the 3D map that matters [m], default 1.0")(
      "start", value("X,Y,YAW"), "in the map frame [m, m, rad]")(
      "goal", value("X,Y,YAW"), "in the map frame [m, m, rad]")("robot", value("FILE"),
                                                                "robot.yaml; default: the values of config/robot.yaml")(
      "planner", value("FILE"), "planner.yaml; default: the values of config/planner.yaml")(
      "modes", value("MODES"), ("modes to plan in, default " + planned_mode_names(",", ",")).c_str())(
      "frontend-only", "stop after the front end's own trajectory")("repeat", value("N"),
                                                                    "plan N times and report the medians of the times")(
      "json", value("FILE"), "write status, metrics and trajectory; - is the standard output")(
      "csv", value("FILE"), "write the trajectory's points")("svg", value("FILE"), "draw map, footprints and path")(
      "corridors", "draw the regions that the optimisation kept the disc centres in, too")(
      "iterations", "draw what each round of the optimisation made of the path, and with --corridors its regions");
  return options;
}

po::variables_map read(int argc, const char* const* argv, const po::options_description& options)
{
  namespace style = po::command_line_style;
  const po::parsed_options parsed =
      po::command_line_parser(argc, argv).options(options).style(style::unix_style & ~style::allow_guessing).run();
  for (const po::option& option : parsed.options)
    if (option.position_key >= 0) throw po::error("'" + option.value.front() + "' belongs to no option");
  po::variables_map given;
  po::store(parsed, given);
  return given;
}

/// The value of an option, empty where it is not given.
std::string text_of(const po::variables_map& given, const std::string& option)
{
  return given.count(option) > 0 ? given[option].as<std::string>() : std::string();
}

void check_combination(const po::variables_map& given)
{
  for (const char* const option : {"start", "goal"})
    if (given.count(option) == 0) throw po::required_option(std::string("--") + option);
  if (text_of(given, "map").empty() == text_of(given, "octomap").empty())
    throw po::error("exactly one of --map MAP.yaml and --octomap FILE.bt is required");
  for (const char* const option : {"height-min", "height-max"})
    if (given.count(option) > 0 && given.count("octomap") == 0)
      throw po::error(std::string("--") + option + " requires --octomap");
  for (const char* const option : {"corridors", "iterations"})
    if (given.count(option) > 0 && given.count("svg") == 0)
      throw po::error(std::string("--") + option + " requires --svg");
  for (const char* const option : {"csv", "svg"})
    if (text_of(given, option) == "-")
      reject_value(std::string("--") + option, "-", "a file: only --json writes to the standard output");
}

PlanArguments arguments_in(const po::variables_map& given)
{
  PlanArguments arguments;
  arguments.map = text_of(given, "map");
  arguments.octomap = text_of(given, "octomap");
  arguments.start = pose_in("--start", text_of(given, "start"));
  arguments.goal = pose_in("--goal", text_of(given, "goal"));
  if (given.count("height-min") > 0) arguments.band.min = height_in("--height-min", text_of(given, "height-min"));
  if (given.count("height-max") > 0) arguments.band.max = height_in("--height-max", text_of(given, "height-max"));
  if (!(arguments.band.min < arguments.band.max))
    throw po::error("--height-max: expected to be greater than --height-min");
  arguments.robot = text_of(given, "robot");
  arguments.planner = text_of(given, "planner");
  if (given.count("modes") > 0) arguments.modes = modes_in(text_of(given, "modes"));
  arguments.frontend_only = given.count("frontend-only") > 0;
  arguments.corridors = given.count("corridors") > 0;
  arguments.iterations = given.count("iterations") > 0;
  if (given.count("repeat") > 0) arguments.repeat = repetitions_in(text_of(given, "repeat"));
  arguments.json = expand_home(text_of(given, "json"));
  arguments.csv = expand_home(text_of(given, "csv"));
  arguments.svg = expand_home(text_of(given, "svg"));
  return arguments;
}

std::string help_text(const po::options_description& options)
{
  std::ostringstream text;
  text << "Plans a verified multi-modal trajectory of a 4WIS robot on a map.\n" << options << kFooter << '\n';
  return text.str();
}

/// Where the JSON shall go. Other arguments may be wrong.
std::string json_file_in(int argc, const char* const* argv)
{
  const std::string option = "--json";
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == option && i + 1 < argc) return expand_home(argv[i + 1]);
    if (word.compare(0, option.size() + 1, option + "=") == 0) return expand_home(word.substr(option.size() + 1));
  }
  return "";
}

}  // namespace

PlanArguments parse_arguments(int argc, const char* const* argv)
{
  const po::options_description options = known_options();
  try
  {
    const po::variables_map given = read(argc, argv, options);
    PlanArguments printed;
    if (given.count("help") > 0) printed.text = help_text(options);
    if (given.count("list-parameters") > 0) printed.text += parameter_documentation();
    if (!printed.text.empty()) return printed;
    check_combination(given);
    return arguments_in(given);
  }
  catch (const po::error& error)
  {
    throw UsageError(error.what(), json_file_in(argc, argv));
  }
}

}  // namespace fourwis
