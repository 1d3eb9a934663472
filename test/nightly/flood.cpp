// Random planning problems, whose answers are held against a flood of the exact rectangle and against the body's own drive.
// Exit status 1 when an answer is wrong, 2 for arguments that make no sense.

#include <algorithm>
#include <iostream>
#include <map>
#include <stdexcept>

#include <boost/program_options.hpp>

#include "../benchmark/table.h"
#include "fourwis_navigation/map/map_file.h"
#include "place.h"

namespace po = boost::program_options;

namespace fourwis::nightly
{
namespace
{

constexpr int kProblemsOfAPlace = 5;
constexpr int kReport = 50;  ///< problems from one line of progress to the next

struct Arguments
{
  int problems = 0;
  unsigned seed = 0;
  std::vector<std::string> maps;
};

po::options_description options()
{
  po::options_description all(
      "nightly_flood [OPTION]... [MAP.yaml]...\n"
      "Plans random problems and judges the answers. A place of its own seed has five of them; with maps, each map is "
      "one "
      "place with all of them.\nOptions");
  auto add = all.add_options();
  add("help,h", "this text");
  add("problems", po::value<int>()->default_value(1000), "how many");
  add("seed", po::value<unsigned>()->default_value(1), "of the first place; the next one has the next");
  add("map", po::value<std::vector<std::string>>()->composing(), "a map instead of random places; may be repeated");
  return all;
}

Arguments arguments_in(const po::variables_map& given)
{
  Arguments arguments;
  arguments.problems = given["problems"].as<int>();
  arguments.seed = given["seed"].as<unsigned>();
  if (given.count("map") > 0) arguments.maps = given["map"].as<std::vector<std::string>>();
  if (arguments.problems < 1) throw po::error("--problems must be 1 or more");
  return arguments;
}

PlannerOptions planner_options()
{
  PlannerOptions options;
  options.planner_patience = 600.0;  // the answers must not depend on how fast the machine is
  return options;
}

/// How often each status was the answer.
class Statistics
{
public:
  void plan_and_count(const Place& place, const PlanRequest& request, const std::string& name)
  {
    const PlanResult result = Planner(planner_options()).plan(place.world, request);
    Count& count = counts_[to_string(result.status)];
    ++count.answers;
    count.ways += place.flood.joins(request.start, request.goal) ? 1 : 0;
    if (++problems_ % kReport == 0) std::cout << problems_ << " problems answered" << std::endl;
    const std::string fault = fault_in_answer(place, request, result);
    if (fault.empty()) return;
    ++count.wrong;
    std::cout << name << ", " << text(request.start) << " to " << text(request.goal) << ", " << text(request.modes)
              << ": " << to_string(result.status) << " (" << result.message << "), but " << fault << std::endl;
  }

  bool all_right() const
  {
    return std::all_of(counts_.begin(), counts_.end(), [](const auto& entry) { return entry.second.wrong == 0; });
  }

  void print() const
  {
    benchmark::Table table({"answer", "problems", "flood: a way", "none", "wrong"});
    for (const auto& [status, count] : counts_)
      table.add({status, std::to_string(count.answers), std::to_string(count.ways),
                 std::to_string(count.answers - count.ways), std::to_string(count.wrong)});
    table.print(std::cout, false);
  }

private:
  struct Count
  {
    int answers = 0, ways = 0, wrong = 0;
  };
  std::map<std::string, Count> counts_;
  int problems_ = 0;
};

void plan_on_maps(const Arguments& arguments, Statistics& statistics)
{
  for (const std::string& map : arguments.maps)
  {
    Random random(arguments.seed);
    const Place place(read_map_file(map), Robot(), planner_options());
    for (int k = 0; k < arguments.problems; ++k) statistics.plan_and_count(place, place.request(random), map);
  }
}

void plan_on_random_places(const Arguments& arguments, Statistics& statistics)
{
  for (int k = 0; k < arguments.problems; k += kProblemsOfAPlace)
  {
    const unsigned seed = arguments.seed + static_cast<unsigned>(k / kProblemsOfAPlace);
    Random random(seed);
    const Place place(random_grid(random), Robot(), planner_options());
    for (int i = k; i < std::min(k + kProblemsOfAPlace, arguments.problems); ++i)
      statistics.plan_and_count(place, place.request(random), "seed " + std::to_string(seed));
  }
}

int run(int argc, char** argv)
{
  const po::options_description all = options();
  po::positional_options_description maps;
  maps.add("map", -1);
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(all).positional(maps).run(), given);
  if (given.count("help") > 0)
  {
    std::cout << all;
    return 0;
  }
  const Arguments arguments = arguments_in(given);
  std::cout << arguments.problems << " problems" << (arguments.maps.empty() ? "" : " on each map") << ", seed "
            << arguments.seed << std::endl;
  Statistics statistics;
  if (arguments.maps.empty())
    plan_on_random_places(arguments, statistics);
  else
    plan_on_maps(arguments, statistics);
  statistics.print();
  return statistics.all_right() ? 0 : 1;
}

}  // namespace
}  // namespace fourwis::nightly

int main(int argc, char** argv)
{
  try
  {
    return fourwis::nightly::run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::cerr << "nightly_flood: " << error.what() << '\n';
    return 2;
  }
}
