#include "fourwis_navigation/map/obstacle_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{
namespace
{

/// Of grids that mean something: side of a cell [m], and coordinates of the origin, of which millimetres are left [m, rad].
constexpr double kLeastResolution = 1e-9, kMostResolution = 1e9, kFarthestOrigin = 1e12;
/// Bounds of the clearance closer than this many cell diagonals are replaced by its exact value.
constexpr double kExactWithin = 1.0;
constexpr std::uint16_t kNone = std::numeric_limits<std::uint16_t>::max();

/// Cells to the nearest obstacle of the same row, looking along `step` from each cell; 0 on an obstacle.
template <typename Neighbours, typename Member>
void scan_row(const std::uint8_t* obstacle, int begin, int end, int step, Neighbours* cells, Member side)
{
  std::uint16_t distance = kNone;
  for (int i = begin; i != end; i += step)
  {
    distance = obstacle[i] ? 0 : static_cast<std::uint16_t>(std::min<int>(distance + 1, kNone));
    cells[i].*side = distance;
  }
}

/// Lower envelope of the parabolas (q - i)^2 + squared[i] over one row: Felzenszwalb and Huttenlocher, "Distance
/// transforms of sampled functions", 2012.
class LowerEnvelope
{
public:
  explicit LowerEnvelope(int size)
    : squared_(static_cast<std::size_t>(size)),
      vertex_(static_cast<std::size_t>(size)),
      bound_(static_cast<std::size_t>(size) + 1)
  {}

  /// Replaces row[i], the square of the distance in i's column, by the square of the distance in the plane.
  void apply(float* row, float infinity)
  {
    const int n = static_cast<int>(squared_.size());
    std::copy(row, row + n, squared_.begin());
    int last = -1;
    for (int q = 0; q < n; ++q)
      if (squared_[at(q)] < infinity) last = push(q, last);
    if (last < 0) return;
    for (int q = 0, k = 0; q < n; ++q)
    {
      while (k < last && bound_[at(k + 1)] < q) ++k;
      const float d = static_cast<float>(q - vertex_[at(k)]);
      row[q] = d * d + squared_[at(vertex_[at(k)])];
    }
  }

private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  int push(int q, int last)
  {
    double from = -std::numeric_limits<double>::infinity();
    while (last >= 0)
    {
      const int p = vertex_[at(last)];
      const double rise = static_cast<double>(squared_[at(q)]) - squared_[at(p)];
      from = (rise + static_cast<double>(q + p) * (q - p)) / (2.0 * (q - p));
      if (from > bound_[at(last)]) break;
      --last;
    }
    if (last < 0) from = -std::numeric_limits<double>::infinity();
    ++last;
    vertex_[at(last)] = q;
    bound_[at(last)] = from;
    return last;
  }

  std::vector<float> squared_;
  std::vector<int> vertex_;
  std::vector<double> bound_;
};

/// Distance of every cell's square to the nearest obstacle square [cells]. The gap between two squares is the distance
/// between the one's centre and the nearest of the 3 x 3 centres around the other, so obstacles grow by one cell first.
void square_distances(const std::vector<std::uint8_t>& obstacle, int width, int height, std::vector<float>& field)
{
  const std::size_t w = static_cast<std::size_t>(width);
  const float infinity = 1e12f;
  std::vector<std::uint8_t> grown_in_row(w);
  field.assign(w * static_cast<std::size_t>(height), infinity);
  for (int j = 0; j < height; ++j)
  {
    const std::uint8_t* row = &obstacle[static_cast<std::size_t>(j) * w];
    for (int i = 0; i < width; ++i)
      grown_in_row[static_cast<std::size_t>(i)] = row[i] || (i > 0 && row[i - 1]) || (i + 1 < width && row[i + 1]);
    for (int k = std::max(0, j - 1); k <= std::min(height - 1, j + 1); ++k)
      for (std::size_t i = 0; i < w; ++i)
        if (grown_in_row[i]) field[static_cast<std::size_t>(k) * w + i] = 0.0f;
  }

  const auto relax_from = [&](int j, int neighbour) {
    float* row = &field[static_cast<std::size_t>(j) * w];
    const float* other = &field[static_cast<std::size_t>(neighbour) * w];
    for (std::size_t i = 0; i < w; ++i) row[i] = std::min(row[i], other[i] + 1.0f);
  };
  for (int j = 1; j < height; ++j) relax_from(j, j - 1);
  for (int j = height - 2; j >= 0; --j) relax_from(j, j + 1);

  LowerEnvelope envelope(width);
  for (int j = 0; j < height; ++j)
  {
    float* row = &field[static_cast<std::size_t>(j) * w];
    for (std::size_t i = 0; i < w; ++i) row[i] = row[i] < infinity ? row[i] * row[i] : infinity;
    envelope.apply(row, infinity);
  }
}

}  // namespace

void check_grid(const OccupancyGrid& grid)
{
  if (grid.width <= 0 || grid.height <= 0)
    reject<std::invalid_argument>("occupancy grid: width x height is ", grid.width, " x ", grid.height,
                                  ", expected at least 1 x 1 cells");
  const std::size_t cells = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
  if (grid.data.size() != cells)
    reject<std::invalid_argument>("occupancy grid: data has ", grid.data.size(),
                                  " cells, expected width x height = ", cells);
  if (!std::isfinite(grid.resolution) || grid.resolution <= 0.0)
    reject<std::invalid_argument>("occupancy grid: resolution is ", grid.resolution, " m, expected a positive number");
  if (grid.resolution < kLeastResolution || grid.resolution > kMostResolution)
    reject<std::invalid_argument>("occupancy grid: resolution is ", grid.resolution, " m, expected ", kLeastResolution,
                                  " to ", kMostResolution, " m");
  if (!is_finite(grid.origin)) reject<std::invalid_argument>("occupancy grid: origin is not finite");
  for (double coordinate : {grid.origin.x, grid.origin.y, grid.origin.theta})
    if (std::abs(coordinate) > kFarthestOrigin)
      reject<std::invalid_argument>("occupancy grid: origin is (", grid.origin.x, ", ", grid.origin.y, ", ",
                                    grid.origin.theta, "), expected numbers within +-", kFarthestOrigin);
}

ObstacleMap::ObstacleMap(const OccupancyGrid& grid, const ObstacleRule& rule)
  : width_(grid.width),
    height_(grid.height),
    resolution_(grid.resolution),
    origin_(grid.origin),
    cos_(std::cos(grid.origin.theta)),
    sin_(std::sin(grid.origin.theta)),
    slack_(M_SQRT2 * grid.resolution * (1.0 + 1e-5))
{
  check_grid(grid);
  check(rule);
  std::vector<std::uint8_t> obstacle(grid.data.size());
  for (std::size_t i = 0; i < obstacle.size(); ++i) obstacle[i] = rule.is_obstacle(grid.data[i]);

  neighbours_.resize(obstacle.size());
  for (int j = 0; j < height_; ++j)
  {
    scan_row(&obstacle[index(0, j)], 0, width_, 1, &neighbours_[index(0, j)], &RowNeighbours::left);
    scan_row(&obstacle[index(0, j)], width_ - 1, -1, -1, &neighbours_[index(0, j)], &RowNeighbours::right);
  }

  square_distances(obstacle, width_, height_, field_);
  const float rounding = 1.0f - 1e-6f;  // a lower bound in spite of single precision
  for (int j = 0; j < height_; ++j)
    for (int i = 0; i < width_; ++i)
    {
      const int border = std::min(std::min(i, width_ - 1 - i), std::min(j, height_ - 1 - j));
      const float cells = std::min(std::sqrt(field_[index(i, j)]), static_cast<float>(border));
      field_[index(i, j)] = cells * static_cast<float>(resolution_) * rounding;
    }
}

void ObstacleMap::to_cells(double x, double y, double& column, double& row) const
{
  const double dx = x - origin_.x, dy = y - origin_.y;
  column = (cos_ * dx + sin_ * dy) / resolution_;
  row = (-sin_ * dx + cos_ * dy) / resolution_;
}

int ObstacleMap::next_obstacle(int column, int row) const
{
  // Distances are cut at what a RowNeighbours holds, so a look may end on the way.
  while (column < width_ && neighbours_[index(column, row)].right > 0) column += neighbours_[index(column, row)].right;
  return std::min(column, width_);
}

double ObstacleMap::exact_cells(double u, double v, double limit, double enough) const
{
  const int column = std::min(static_cast<int>(u), width_ - 1);
  const int centre_row = std::min(static_cast<int>(v), height_ - 1);
  const double best = std::min({limit, u, width_ - u, v, height_ - v});
  double best_squared = best * best;
  const double enough_squared = enough * enough;

  const auto look = [&](int row, double dy) {
    const RowNeighbours& nearest = neighbours_[index(column, row)];
    const double dx = nearest.left == 0 ? 0.0 : std::min(u - (column - nearest.left + 1), column + nearest.right - u);
    best_squared = std::min(best_squared, dx * dx + dy * dy);
  };
  look(centre_row, 0.0);
  for (int step = 1;; ++step)
  {
    const double up = centre_row + step - v, down = v - (centre_row - step + 1);
    const bool look_up = up * up < best_squared && centre_row + step < height_;
    const bool look_down = down * down < best_squared && centre_row - step >= 0;
    if ((!look_up && !look_down) || best_squared < enough_squared) break;
    if (look_up) look(centre_row + step, up);
    if (look_down) look(centre_row - step, down);
  }
  return std::sqrt(best_squared);
}

double ObstacleMap::distance(double x, double y) const
{
  double u, v;
  to_cells(x, y, u, v);
  if (!(u >= 0.0 && v >= 0.0 && u <= width_ && v <= height_)) return 0.0;
  return exact_cells(u, v, std::numeric_limits<double>::infinity(), 0.0) * resolution_;
}

bool ObstacleMap::is_clear(double x, double y, double radius) const
{
  double u, v;
  to_cells(x, y, u, v);
  if (!(u >= 0.0 && v >= 0.0 && u < width_ && v < height_)) return radius <= 0.0;
  const double bound = field_[index(static_cast<int>(u), static_cast<int>(v))];
  if (bound >= radius) return true;
  if (bound + slack_ < radius) return false;
  const double limit = radius / resolution_;
  return exact_cells(u, v, limit, limit) >= limit;
}

bool ObstacleMap::is_clear(double x, double y, double radius, double& clearance) const
{
  double u, v;
  to_cells(x, y, u, v);
  if (!(u >= 0.0 && v >= 0.0 && u < width_ && v < height_))
  {
    if (!(radius <= 0.0)) return false;
    clearance = std::min(clearance, -radius);
    return true;
  }
  const double bound = field_[index(static_cast<int>(u), static_cast<int>(v))] - radius;
  if (bound + slack_ < 0.0) return false;
  if (bound >= clearance) return true;
  // Far from obstacles the bound is good enough, close to them a cell more or less makes the difference.
  const double exact =
      bound >= kExactWithin * slack_
          ? bound
          : exact_cells(u, v, (radius + bound + slack_) / resolution_, radius / resolution_) * resolution_ - radius;
  if (exact < 0.0) return false;
  clearance = std::min(clearance, exact);
  return true;
}

}  // namespace fourwis
