#include "ablation.h"

#include <array>
#include <chrono>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/referee/referee.h"
#include "fourwis_navigation/search/search.h"
#include "planner/stop_and_steer.h"
#include "search/motion_cost.h"
#include "statistics.h"

namespace fourwis::benchmark
{
namespace
{

struct Variant
{
  const char* name;
  bool terminal_connection, switching_awareness;
  double paper_length, paper_position_error, paper_yaw_error, paper_ms;
};

constexpr std::array<Variant, 4> kVariants = {{{"Only MP", false, false, 18.700, 0.202, 0.003, 116.8},
                                               {"MP+RS", true, false, 18.745, 0.000, 0.000, 185.0},
                                               {"MP+SCH", false, true, 15.500, 0.195, 0.003, 131.8},
                                               {"Full", true, true, 15.235, 0.000, 0.000, 35.44}}};

/// Length of the path and what its switches cost as lengths, whether or not the search that found it minded them.
double equivalent_length(const Path& path, const Setup& setup)
{
  SearchOptions options = setup.options.search;
  options.switching_awareness = true;
  const MotionCost cost(setup.robot, options);
  double length = path.length() + path.switches() * cost.mode_switch(false);
  if (!path.pieces.empty() && path.pieces.front().mode != setup.modes.first()) length += cost.mode_switch(true);
  return length;
}

struct Outcome
{
  SearchResult found;
  std::vector<double> ms;
};

/// The front end alone: the planner as a whole insists on the exact goal, which two of the variants do not reach.
Outcome run(const Setup& setup, const SearchOptions& options, const OccupancyGrid& grid, const PlanRequest& request)
{
  Outcome outcome;
  for (int i = 0; i < setup.runs; ++i)
  {
    const auto begin = std::chrono::steady_clock::now();
    const ObstacleMap map(grid, setup.options.obstacles);
    const CollisionChecker checker(map, setup.robot);
    outcome.found = Search({checker, request.start, request.goal}).find(options, request.modes);
    outcome.ms.push_back(ms_since(begin));
  }
  return outcome;
}

std::vector<std::string> row(const Variant& variant, const Setup& setup, const OccupancyGrid& grid,
                             const PlanRequest& request)
{
  SearchOptions options = setup.options.search;
  options.terminal_connection = variant.terminal_connection;
  options.switching_awareness = variant.switching_awareness;
  const Outcome outcome = run(setup, options, grid, request);
  const Path& path = outcome.found.path;
  std::vector<std::string> cells(7, "-");
  if (outcome.found.status == PlanStatus::succeeded)
  {
    const Referee referee(grid, setup.options.obstacles, setup.robot, setup.options.referee);
    const Trajectory trajectory = stop_and_steer(path, setup.robot);
    cells = {referee.judge(request.start, path.goal, trajectory).accepted() ? "yes" : "no",
             fixed(equivalent_length(path, setup), 3),
             std::to_string(path.switches()),
             fixed(distance(path.goal, request.goal), 3),
             fixed(std::abs(wrap_angle(path.goal.theta - request.goal.theta)), 3),
             fixed(median(outcome.ms), 2),
             fixed(worst(outcome.ms), 2)};
  }
  cells.insert(cells.begin(), {variant.name, to_string(outcome.found.status)});
  cells.insert(cells.end(),
               {std::to_string(outcome.found.expansions), fixed(variant.paper_length, 3),
                fixed(variant.paper_position_error, 3), fixed(variant.paper_yaw_error, 3), fixed(variant.paper_ms, 1)});
  return cells;
}

}  // namespace

void report_ablation(const Report& report, const Setup& setup, const Problem& problem)
{
  Table table({"variant", "status", "SF", "TL m", "switches", "TPE m", "TYE rad", "CT ms", "worst", "expansions",
               "paper TL", "paper TPE", "paper TYE", "paper CT"});
  MapCache maps;
  const OccupancyGrid& grid = maps.grid(problem.map);
  const PlanRequest request{problem.start, problem.goal, setup.modes};
  for (const Variant& variant : kVariants) table.add(row(variant, setup, grid, request));
  report.title("Ablation of the front end on " + problem.id);
  report.table(table);
  report.line("TL with the equivalent length of the switches; CT from the grid to the path, medians of " +
              std::to_string(setup.runs) + " runs. The paper's map is another one of the same description.");
}

}  // namespace fourwis::benchmark
