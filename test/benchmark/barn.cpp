#include "barn.h"

#include <cmath>
#include <limits>
#include <optional>

#include "barn_map.h"
#include "brute_force_flood.h"
#include "fourwis_navigation/map/map_file.h"
#include "problem.h"
#include "statistics.h"

namespace fourwis::benchmark
{
namespace
{

constexpr double kOpenAbove = 2.1;  ///< of free space added above the obstacles [m]
constexpr double kStartAt = 2.0;    ///< height of the wanted start above the lower edge [m]
constexpr double kGoalAt = 1.05;    ///< and of the wanted goal above the upper edge [m]
constexpr double kLattice = 0.05;   ///< poses are chosen from a lattice this fine [m]

/// The dataset's own robot.
Robot small_robot()
{
  Robot robot;
  robot.length = 0.51;
  robot.width = 0.43;
  robot.wheelbase = 0.34;
  robot.track_width = 0.34;
  return robot;
}

/// The free pose heading along the corridor nearest to a point.
std::optional<Pose> free_pose_near(const OccupancyGrid& grid, const BruteForceFlood& flood, const Pose& wanted)
{
  std::optional<Pose> best;
  double least = std::numeric_limits<double>::infinity();
  const double width = grid.width * grid.resolution, height = grid.height * grid.resolution;
  for (int i = 0; i * kLattice < width; ++i)
    for (int j = 0; j * kLattice < height; ++j)
    {
      const Pose pose{i * kLattice, j * kLattice, M_PI_2};
      const double d = distance(pose, wanted);
      if (d >= least || !flood.is_free(pose)) continue;
      best = pose;
      least = d;
    }
  return best;
}

/// What became of one robot on all maps.
struct Statistics
{
  std::size_t maps = 0, connected = 0, solved = 0, solved_of_connected = 0, refused = 0;
  std::vector<double> medians;  ///< of the problems solved
  /// Where the planner has no plan although the flood has a way, or could not tell that there is none.
  std::size_t surprises = 0;
  Table surprising{{"map", "start", "goal", "connected", "status", "expansions", "front end ms"}};
};

std::string text(const Pose& pose)
{
  return fixed(pose.x, 2) + "," + fixed(pose.y, 2) + "," + fixed(pose.theta, 6);
}

void count(Statistics& statistics, const Problem& problem, bool connected, const Measurement& measurement)
{
  const PlanStatus status = measurement.result.status;
  const bool solved = status == PlanStatus::succeeded, refused = status == PlanStatus::goal_unreachable;
  ++statistics.maps;
  statistics.connected += connected;
  statistics.solved += solved;
  statistics.solved_of_connected += solved && connected;
  statistics.refused += refused && !connected;
  if (solved) statistics.medians.push_back(median(measurement.frontend_ms));
  if (solved || (refused && !connected)) return;
  ++statistics.surprises;
  statistics.surprising.add({problem.id, text(problem.start), text(problem.goal), connected ? "yes" : "no",
                             to_string(status), std::to_string(measurement.result.metrics.expansions),
                             fixed(median(measurement.frontend_ms), 1)});
}

std::vector<Problem> cross(Statistics& statistics, const Setup& setup, const std::vector<BarnMap>& maps)
{
  std::vector<Problem> problems;
  for (const BarnMap& map : maps)
  {
    const BruteForceFlood flood(map.grid, setup.options.obstacles, setup.robot);
    const double middle = map.grid.width * map.grid.resolution / 2.0;
    const std::optional<Pose> start = free_pose_near(map.grid, flood, {middle, kStartAt, 0.0});
    const std::optional<Pose> goal = free_pose_near(map.grid, flood, {middle, map.top + kGoalAt, 0.0});
    if (!start || !goal) throw std::runtime_error(map.name + ": no room for the robot");
    problems.push_back({map.name, map.name + ".yaml", *start, *goal});
    count(statistics, problems.back(), flood.joins(*start, *goal), measure(setup, map.grid, *start, *goal));
  }
  return problems;
}

std::string share(std::size_t part, std::size_t whole)
{
  return std::to_string(part) + " (" + fixed(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1) + " %)";
}

}  // namespace

void report_barn(const Report& report, const Setup& setup, const std::string& folder, const std::string& export_folder)
{
  const std::vector<BarnMap> maps = read_barn_maps(folder, kOpenAbove);
  if (!export_folder.empty())
    for (const BarnMap& map : maps) write_map_file(map.grid, export_folder + "/" + map.name);

  Table table({"robot m", "maps", "solved", "connected", "solved of connected", "solved of the others",
               "refused of the others", "p50 ms", "p95 ms", "max ms"});
  std::vector<std::pair<std::string, Statistics>> all_statistics;
  for (const Robot& robot : {setup.robot, small_robot()})
  {
    Setup with_robot = setup;
    with_robot.robot = robot;
    const std::string size = fixed(robot.length, 2) + " x " + fixed(robot.width, 2);
    Statistics statistics;
    const std::vector<Problem> problems = cross(statistics, with_robot, maps);
    if (!export_folder.empty())
      write_problems(export_folder + "/problems_" + fixed(robot.length, 2) + ".csv", problems);
    table.add({size, std::to_string(statistics.maps), share(statistics.solved, statistics.maps),
               share(statistics.connected, statistics.maps),
               share(statistics.solved_of_connected, statistics.connected),
               share(statistics.solved - statistics.solved_of_connected, statistics.maps - statistics.connected),
               share(statistics.refused, statistics.maps - statistics.connected), fixed(median(statistics.medians), 2),
               fixed(quantile(statistics.medians, 0.95), 2), fixed(worst(statistics.medians), 2)});
    all_statistics.emplace_back(size, std::move(statistics));
  }
  report.title("BARN maps");
  report.table(table);
  for (const auto& [size, statistics] : all_statistics)
  {
    if (statistics.surprises == 0) continue;
    report.line("Robot " + size + ", neither solved nor, where not connected, refused as unreachable:");
    report.table(statistics.surprising);
  }
}

}  // namespace fourwis::benchmark
