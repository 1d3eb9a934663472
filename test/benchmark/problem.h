#pragma once

#include <limits>
#include <string>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis::benchmark
{

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// One line of a file of planning problems, with what it says of another planner; kUnknown where it says nothing.
struct Problem
{
  std::string id;
  std::string map;  ///< YAML, as seen from the working directory
  Pose start, goal;
  double peer_ms = kUnknown;            ///< front end, CPU time [ms]
  double peer_backend_ms = kUnknown;    ///< back end, CPU time [ms]
  double peer_arrival_time = kUnknown;  ///< AT [s]
  double peer_length = kUnknown;        ///< TL [m]
};

/// Reads `id;map;start;goal` and, where the file has them, `peer_frontend_cpu_ms`, `peer_backend_cpu_ms`, `peer_AT_s`
/// and `peer_TL_m`; the columns are found by the header. Maps are relative to the file. Throws std::runtime_error
/// naming file, line and what was expected.
std::vector<Problem> read_problems(const std::string& path);

/// The inverse: writes `id;map;start;goal`, the maps as they are. Throws std::runtime_error.
void write_problems(const std::string& path, const std::vector<Problem>& problems);

/// Keeps the map read last: problems on one map follow one another.
class MapCache
{
public:
  const OccupancyGrid& grid(const std::string& map);

private:
  std::string map_;
  OccupancyGrid grid_;
};

}  // namespace fourwis::benchmark
