#pragma once

#include <vector>

#include "fourwis_navigation/map/obstacle_map.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/vehicle/body.h"

namespace fourwis
{

/// A pose with the cosine and sine of its heading.
struct Placed
{
  double x, y, cosine, sine;
};

Placed placed(const Pose& pose);

/// Whether a body at a pose lies in the grid and overlaps no obstacle: exactly, cell by cell. To touch is no overlap.
bool is_clear(const ObstacleMap& map, const ConvexPolygon& body, const Placed& place);

/// Whether no part of the body lies outside the grid.
bool lies_in(const ObstacleMap& map, const ConvexPolygon& body, const Pose& pose);

struct CellIndex
{
  int column, row;
};

/// The cells of the grid that the body overlaps, row by row.
std::vector<CellIndex> overlapped_cells(const ObstacleMap& map, const ConvexPolygon& body, const Pose& pose);

/// By how much each side of the body can be moved outward before it overlaps an obstacle, at most `most` [m]. Negative where
/// the body overlaps: by how much its sides have to be moved inward until it is clear; -infinity where it never is.
double body_clearance(const ObstacleMap& map, const ConvexPolygon& body, const Pose& pose, double most);

}  // namespace fourwis
