#include "setup_arguments.h"

#include <sstream>
#include <stdexcept>

#include "fourwis_navigation/parameters/parameters.h"

namespace po = boost::program_options;

namespace fourwis::benchmark
{
namespace
{

ModeSet modes_in(const std::string& text)
{
  ModeSet modes = ModeSet::none();
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');)
  {
    const std::optional<Mode> mode = mode_from_string(word);
    if (!mode) throw std::runtime_error("--modes: '" + word + "' is none of ackermann, lateral, parallel");
    modes.insert(*mode);
  }
  if (modes.empty()) throw std::runtime_error("--modes: expected at least one mode");
  return modes;
}

}  // namespace

void add_setup_options(po::options_description& options)
{
  auto add = options.add_options();
  add("runs", po::value<int>()->default_value(20), "runs of each problem");
  add("modes", po::value<std::string>()->default_value("ackermann,lateral,parallel"), "modes to plan in");
  add("robot", po::value<std::string>()->default_value(""), "robot.yaml instead of the paper's robot");
  add("planner", po::value<std::string>()->default_value(""), "planner.yaml instead of the defaults");
  add("markdown", "print tables for a Markdown file");
}

po::variables_map options_given(int argc, const char* const* argv, const po::options_description& options)
{
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(options).positional({}).run(), given);
  po::notify(given);
  return given;
}

std::string help_text(const po::options_description& options)
{
  std::ostringstream text;
  text << options;
  return text.str();
}

std::vector<std::string> files_in(const po::variables_map& given, const std::string& option)
{
  return given.count(option) ? given[option].as<std::vector<std::string>>() : std::vector<std::string>();
}

Setup setup_in(const po::variables_map& given)
{
  Setup setup;
  const std::string robot = given["robot"].as<std::string>(), planner = given["planner"].as<std::string>();
  if (!robot.empty()) setup.robot = read_robot_file(robot);
  if (!planner.empty()) setup.options = read_planner_file(planner);
  setup.modes = modes_in(given["modes"].as<std::string>());
  setup.runs = given["runs"].as<int>();
  if (setup.runs < 1) throw std::runtime_error("--runs: expected at least 1");
  return setup;
}

}  // namespace fourwis::benchmark
