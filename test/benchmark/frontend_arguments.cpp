#include "frontend_arguments.h"

#include <stdexcept>

#include <boost/program_options.hpp>

#include "setup_arguments.h"

namespace po = boost::program_options;

namespace fourwis::benchmark
{
namespace
{

using Files = std::vector<std::string>;

po::options_description options()
{
  po::options_description all("Measures the planner's front end. Options");
  auto add = all.add_options();
  add("help,h", "this text");
  add("problems", po::value<Files>()->composing(), "plan each line id;map;start;goal of a file; may be repeated");
  add("environments", "the same for the project's own environments");
  add("walled-in", "wall the goals of those problems in and time the refusals instead");
  add("ablation", "the variants of the paper's Table III on env4");
  add("barn", po::value<std::string>()->default_value(""), "cross each map_pgm_*.pgm of a folder, with two robots");
  add("export", po::value<std::string>()->default_value(""),
      "with --barn: also write its maps and problems to an existing folder");
  add("map", po::value<Files>()->composing(), "a map_server YAML for --corner-to-corner; may be repeated");
  add("corner-to-corner", "plan across the maps of --map");
  add_setup_options(all);
  return all;
}

void check(const Arguments& arguments)
{
  const bool problems = arguments.environments || !arguments.problems.empty();
  if (arguments.walled_in && !problems) throw std::runtime_error("--walled-in: needs --problems or --environments");
  if (arguments.corner_to_corner == arguments.maps.empty())
    throw std::runtime_error("--map and --corner-to-corner need each other");
  if (!arguments.export_folder.empty() && arguments.barn.empty()) throw std::runtime_error("--export: needs --barn");
  if (!problems && !arguments.ablation && arguments.barn.empty() && arguments.maps.empty())
    throw std::runtime_error("nothing to measure; see --help");
}

}  // namespace

Arguments parse_arguments(int argc, const char* const* argv)
{
  const po::options_description all = options();
  const po::variables_map given = options_given(argc, argv, all);
  Arguments arguments;
  if (given.count("help"))
  {
    arguments.help = help_text(all);
    return arguments;
  }
  arguments.problems = files_in(given, "problems");
  arguments.maps = files_in(given, "map");
  arguments.environments = given.count("environments") > 0;
  arguments.walled_in = given.count("walled-in") > 0;
  arguments.ablation = given.count("ablation") > 0;
  arguments.corner_to_corner = given.count("corner-to-corner") > 0;
  arguments.markdown = given.count("markdown") > 0;
  arguments.barn = given["barn"].as<std::string>();
  arguments.export_folder = given["export"].as<std::string>();
  arguments.setup = setup_in(given);
  check(arguments);
  return arguments;
}

}  // namespace fourwis::benchmark
