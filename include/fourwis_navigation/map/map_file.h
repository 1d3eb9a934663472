#pragma once

#include <stdexcept>
#include <string>

#include "fourwis_navigation/model/occupancy_grid.h"

namespace fourwis
{

/// Unusable map input. what() is one line that names file, field and what was expected.
struct MapFileError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Reads a map in map_server's format: YAML (image, resolution, origin [x, y, yaw], negate, occupied_thresh, free_thresh,
/// optional mode trinary | scale | raw) beside a PGM (P2, P5), PNG, JPEG, BMP or TIFF image, told apart by content. Same cell
/// values as map_server; pixels that are not opaque are unknown in the modes trinary and scale. Both paths may begin with
/// "~/". Where free_thresh makes cells free that a map saver wrote as unseen, `warning` is set to a sentence that says so.
/// Throws MapFileError.
OccupancyGrid read_map_file(const std::string& path, std::string* warning = nullptr);

/// Writes `<stem>.yaml` and `<stem>.pgm` (trinary) that read_map_file() reads back to the same occupied, free and unknown
/// cells. Throws MapFileError.
void write_map_file(const OccupancyGrid& grid, const std::string& stem);

}  // namespace fourwis
