#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// What nav_msgs/OccupancyGrid says, without ROS: row-major from the corner at `origin`, row 0 lowest in y.
struct OccupancyGrid
{
  int width = 0;                  ///< cells along the grid's x axis
  int height = 0;                 ///< cells along the grid's y axis
  double resolution = 0.0;        ///< side of a cell [m]
  Pose origin;                    ///< pose in the map frame of the lower left corner of cell (0, 0)
  std::vector<std::int8_t> data;  ///< 0..100 chance of being occupied in percent, anything else unknown; width * height

  std::int8_t at(int column, int row) const
  {
    return data[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  }
};

/// How cells become obstacles.
struct ObstacleRule
{
  int occupied_threshold = 65;      ///< a known cell of at least this value [percent] is an obstacle
  bool unknown_is_obstacle = true;  ///< whether unknown cells are

  bool is_obstacle(std::int8_t cell) const
  {
    return cell < 0 || cell > 100 ? unknown_is_obstacle : cell >= occupied_threshold;
  }

  /// The table of the options; see option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("occupied_threshold", o.occupied_threshold, 1, 100, "percent");
    row("unknown_is_obstacle", o.unknown_is_obstacle);
  }
};

/// Throws std::invalid_argument naming key, value and range.
void check(const ObstacleRule& rule);

}  // namespace fourwis
