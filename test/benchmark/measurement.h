#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis::benchmark
{

/// What is measured, and how often.
struct Setup
{
  Robot robot;
  PlannerOptions options;
  ModeSet modes;
  int runs = 20;
  bool frontend_only = true;  ///< without the back end
};

/// Repeated runs of one problem.
struct Measurement
{
  PlanResult result;                ///< the same in each run
  std::vector<double> frontend_ms;  ///< from the grid to the paths, obstacle map included
  std::vector<double> verify_ms;
  std::vector<double> map_ms;      ///< of frontend_ms, the obstacle map
  std::vector<double> backend_ms;  ///< corridors and optimisation
  std::vector<double> cpu_ms;      ///< from the grid to the verified trajectory, CPU time of all threads
};

/// Plans `setup.runs` times from the grid, keeping nothing between runs. Throws std::logic_error when two runs differ in
/// more than time: the planner is deterministic, unless planner_patience is over.
Measurement measure(const Setup& setup, const OccupancyGrid& grid, const Pose& start, const Pose& goal);

/// Milliseconds since.
double ms_since(std::chrono::steady_clock::time_point begin);

/// CPU time that all threads of this process have used so far [ms].
double cpu_ms();

}  // namespace fourwis::benchmark
