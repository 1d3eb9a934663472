// How many random problems are solved, of those that a flood of the exact rectangle says can be, and in how much CPU time.
// Exit status 1 when an answer is wrong, 2 for arguments that make no sense.

#include <ctime>
#include <iostream>
#include <map>
#include <memory>
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

/// What floods say of a problem. Each flood has two edges: what lies between is told by none of them.
enum class Verdict
{
  with_margin,  ///< the rectangle with its margin can
  bare_only,    ///< the rectangle can, with its margin it cannot
  impossible,   ///< not even the rectangle can
  undecided
};

const char* const kNames[] = {"with margin", "bare only", "impossible", "undecided"};

class Judge
{
public:
  Judge(const OccupancyGrid& grid, const ObstacleRule& rule, const Robot& robot)
    : margin_inside_(grid, rule, robot, robot.safety_margin + RectangleFlood::half_step(robot)),
      margin_outside_(grid, rule, robot, robot.safety_margin - RectangleFlood::half_step(robot)),
      bare_inside_(grid, rule, robot, RectangleFlood::half_step(robot)),
      bare_outside_(grid, rule, robot, -RectangleFlood::half_step(robot))
  {}

  Verdict judge(const PlanRequest& request) const
  {
    const auto joins = [&](const RectangleFlood& flood) { return flood.joins(request.start, request.goal); };
    if (joins(margin_inside_)) return Verdict::with_margin;
    if (joins(bare_inside_) && !joins(margin_outside_)) return Verdict::bare_only;
    return joins(bare_outside_) ? Verdict::undecided : Verdict::impossible;
  }

private:
  const RectangleFlood margin_inside_, margin_outside_, bare_inside_, bare_outside_;
};

double cpu_seconds()
{
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Figures
{
public:
  void add(const Place& place, const Judge& judge, const PlanRequest& request, const std::string& name, bool verbose)
  {
    const double begin = cpu_seconds();
    PlannerOptions options;
    options.planner_patience = 600.0;  // the answers must not depend on how fast the machine is
    const World world(place.grid, place.robot, options);
    const PlanResult result = Planner(options, 1).plan(world, request);
    const double cpu = cpu_seconds() - begin;
    times_.push_back(cpu);
    const Verdict verdict = judge.judge(request);
    ++counts_[verdict][to_string(result.status)];
    const std::string fault = fault_in_answer(place, request, result);
    wrong_ += fault.empty() ? 0 : 1;
    if (!fault.empty() || (verbose && result.status != PlanStatus::succeeded && verdict != Verdict::impossible) ||
        (verbose && cpu > 0.5))
      std::cout << name << " --start=" << spelled(request.start) << " --goal=" << spelled(request.goal) << ' '
                << kNames[static_cast<int>(verdict)] << ": " << to_string(result.status) << " in " << cpu << " s, "
                << result.message << (fault.empty() ? "" : " BUT " + fault) << std::endl;
  }

  bool all_right() const { return wrong_ == 0; }

  void print() const
  {
    benchmark::Table table({"floods say", "answer", "problems"});
    for (const auto& [verdict, answers] : counts_)
      for (const auto& [status, count] : answers)
        table.add({kNames[static_cast<int>(verdict)], status, std::to_string(count)});
    table.print(std::cout, false);
    std::vector<double> sorted = times_;
    std::sort(sorted.begin(), sorted.end());
    for (double share : {0.5, 0.9, 0.95, 0.99, 1.0})
    {
      const std::size_t last = sorted.size() - 1;
      std::cout << "CPU time, " << 100.0 * share
                << " %: " << 1e3 * sorted[static_cast<std::size_t>(share * static_cast<double>(last))] << " ms\n";
    }
    std::cout << wrong_ << " wrong answers\n";
  }

private:
  static std::string spelled(const Pose& pose)
  {
    return std::to_string(pose.x) + "," + std::to_string(pose.y) + "," + std::to_string(pose.theta);
  }

  std::map<Verdict, std::map<std::string, int>> counts_;
  std::vector<double> times_;
  int wrong_ = 0;
};

int run(int argc, char** argv)
{
  po::options_description all("nightly_figures [OPTION]... MAP.yaml...\nOptions");
  auto add = all.add_options();
  add("help,h", "this text");
  add("problems", po::value<int>()->default_value(20), "on each map");
  add("random", po::value<int>()->default_value(0), "random places besides the maps, with as many problems each");
  add("seed", po::value<unsigned>()->default_value(1), "");
  add("verbose,v", "a line for each problem that was not solved or took long");
  add("map", po::value<std::vector<std::string>>()->composing(), "");
  po::positional_options_description maps;
  maps.add("map", -1);
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(all).positional(maps).run(), given);
  if (given.count("help") > 0)
  {
    std::cout << all;
    return 0;
  }
  Figures figures;
  Random random(given["seed"].as<unsigned>());
  const auto visit = [&](const OccupancyGrid& grid, const std::string& name) {
    const Robot robot;
    const Place place(grid, robot, PlannerOptions());
    const Judge judge(place.grid, PlannerOptions().obstacles, robot);
    for (int k = 0; k < given["problems"].as<int>(); ++k)
    {
      PlanRequest request = place.request(random);
      request.modes = ModeSet();
      figures.add(place, judge, request, name, given.count("verbose") > 0);
    }
  };
  if (given.count("map") > 0)
    for (const std::string& map : given["map"].as<std::vector<std::string>>()) visit(read_map_file(map), map);
  for (int k = 0; k < given["random"].as<int>(); ++k) visit(random_grid(random), "random place " + std::to_string(k));
  figures.print();
  return figures.all_right() ? 0 : 1;
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
    std::cerr << "nightly_figures: " << error.what() << '\n';
    return 2;
  }
}
