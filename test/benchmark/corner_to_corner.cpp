#include "corner_to_corner.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/vehicle/footprint.h"
#include "statistics.h"

namespace fourwis::benchmark
{
namespace
{

/// Cells of the largest 4-connected region where the robot is free at every heading.
class RoomyRegion
{
public:
  RoomyRegion(const ObstacleMap& map, const Robot& robot)
    : map_(map),
      seen_(static_cast<std::size_t>(map.width()) * static_cast<std::size_t>(map.height()), false)
  {
    const TwoDiscs discs = two_discs(robot);
    room_ = discs.offset + discs.radius;
    std::vector<Cell> region;
    for (int row = 0; row < map.height(); ++row)
      for (int column = 0; column < map.width(); ++column)
      {
        flood({column, row}, region);
        if (region.size() > cells_.size()) std::swap(region, cells_);
      }
    if (cells_.empty()) throw std::runtime_error("the robot fits nowhere");
  }

  /// Centre of the cell that lies furthest in a direction of the grid.
  Pose extreme(int right, int up) const
  {
    Cell best = cells_.front();
    for (const Cell& cell : cells_)
      if (right * cell.column + up * cell.row > right * best.column + up * best.row) best = cell;
    return compose(map_.origin(), {(best.column + 0.5) * map_.resolution(), (best.row + 0.5) * map_.resolution(), 0.0});
  }

private:
  struct Cell
  {
    int column, row;
  };

  /// Marks a cell; whether it is a new one with room.
  bool enter(const Cell& cell)
  {
    if (cell.column < 0 || cell.row < 0 || cell.column >= map_.width() || cell.row >= map_.height()) return false;
    const std::size_t index = static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(map_.width()) +
                              static_cast<std::size_t>(cell.column);
    if (seen_[index]) return false;
    seen_[index] = true;
    return map_.cell_distance(cell.column, cell.row) >= room_;
  }

  void flood(const Cell& from, std::vector<Cell>& region)
  {
    region.clear();
    if (!enter(from)) return;
    region.push_back(from);
    for (std::size_t i = 0; i < region.size(); ++i)
    {
      const Cell at = region[i];
      for (const Cell& next : {Cell{at.column + 1, at.row}, Cell{at.column - 1, at.row}, Cell{at.column, at.row + 1},
                               Cell{at.column, at.row - 1}})
        if (enter(next)) region.push_back(next);
    }
  }

  const ObstacleMap& map_;
  std::vector<bool> seen_;
  std::vector<Cell> cells_;
  double room_;  ///< distance to the obstacles that suffices at every heading [m]
};

/// A line of /proc/self/status, "VmRSS" or "VmHWM" [MiB]; NaN where there is no such thing.
double memory_mib(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
    if (word == name + ":")
    {
      double kib;
      status >> kib;
      return kib / 1024.0;
    }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Makes VmHWM start anew at what is in use now; where the kernel refuses, the peak includes choosing start and goal.
void reset_peak_memory()
{
  std::ofstream("/proc/self/clear_refs") << 5;
}

std::string name_of(const std::string& path)
{
  return path.substr(path.find_last_of('/') + 1);
}

std::string text(const Pose& pose)
{
  return fixed(pose.x, 3) + "," + fixed(pose.y, 3) + "," + fixed(pose.theta, 4);
}

std::vector<std::string> row(const Setup& setup, const std::string& path)
{
  const OccupancyGrid grid = read_map_file(path);
  Pose start, goal;
  {
    const ObstacleMap map(grid, setup.options.obstacles);
    const RoomyRegion region(map, setup.robot);
    start = region.extreme(-1, -1);
    goal = region.extreme(1, 1);
    start.theta = goal.theta = std::atan2(goal.y - start.y, goal.x - start.x);
  }
  reset_peak_memory();
  const double before = memory_mib("VmRSS");
  const Measurement measurement = measure(setup, grid, start, goal);
  const PlanMetrics& metrics = measurement.result.metrics;
  return {name_of(path),
          std::to_string(grid.width) + " x " + std::to_string(grid.height),
          text(start),
          text(goal),
          to_string(measurement.result.status),
          fixed(metrics.map_ms, 1),
          fixed(median(measurement.frontend_ms), 1),
          fixed(worst(measurement.frontend_ms), 1),
          std::to_string(metrics.expansions),
          fixed(metrics.length, 1),
          std::to_string(metrics.switches),
          fixed(metrics.arrival_time, 1),
          fixed(median(measurement.verify_ms), 1),
          fixed(before, 1),
          fixed(memory_mib("VmHWM"), 1)};
}

}  // namespace

void report_corner_to_corner(const Report& report, const Setup& setup, const std::vector<std::string>& maps)
{
  Table table({"map", "cells", "start", "goal", "status", "map ms", "front end ms", "worst", "expansions", "TL m",
               "switches", "AT s", "verify ms", "MiB before", "MiB peak"});
  for (const std::string& map : maps) table.add(row(setup, map));
  report.title("Corner to corner");
  report.table(table);
}

}  // namespace fourwis::benchmark
