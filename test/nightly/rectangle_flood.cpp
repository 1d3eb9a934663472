#include "rectangle_flood.h"

#include <algorithm>
#include <cmath>

namespace fourwis::nightly
{
namespace
{

constexpr double kStep = 0.025;        ///< between neighbours of the lattice [m]
constexpr std::size_t kHalfTurn = 60;  ///< headings in half a turn: then the rectangle looks the same
constexpr std::size_t kHeadings = 2 * kHalfTurn;
constexpr double kTurn = M_PI / kHalfTurn;  ///< between neighbours [rad]
constexpr double kTouch = 1e-9;             ///< less overlap than this is none [m]

/// Open at both ends.
struct Interval
{
  double low, high;

  /// What of it has |slope x + offset| < limit.
  void cut(double slope, double offset, double limit)
  {
    if (std::abs(slope) < 1e-12)
    {
      if (std::abs(offset) >= limit) high = low;
      return;
    }
    const double one = (-limit - offset) / slope, other = (limit - offset) / slope;
    low = std::max(low, std::min(one, other));
    high = std::min(high, std::max(one, other));
  }
};

std::size_t rounded(double value, std::size_t count)
{
  return static_cast<std::size_t>(std::clamp(std::lround(value), 0L, static_cast<long>(count) - 1));
}

/// The lattice's lines strictly between two coordinates: the first of them, and the one after the last.
struct Lines
{
  std::size_t first, end;

  Lines(double low, double high, std::size_t count)
    : first(static_cast<std::size_t>(std::max(0.0, std::floor(low / kStep) + 1.0))),
      end(static_cast<std::size_t>(std::clamp(std::ceil(high / kStep), 0.0, static_cast<double>(count))))
  {}
};

}  // namespace

/// The rectangle at a heading against a square cell, by the theorem of separating axes.
struct RectangleFlood::Shape
{
  Shape(double half_length, double half_width, double heading, double half_cell)
    : c(std::cos(heading)),
      s(std::sin(heading)),
      reach_x(half_length * std::abs(c) + half_width * std::abs(s)),
      reach_y(half_length * std::abs(s) + half_width * std::abs(c)),
      to_cell_x(reach_x + half_cell - kTouch),
      to_cell_y(reach_y + half_cell - kTouch),
      along(half_length + half_cell * (std::abs(c) + std::abs(s)) - kTouch),
      across(half_width + half_cell * (std::abs(c) + std::abs(s)) - kTouch)
  {}

  /// The dx at which the centre of the rectangle, dy above that of a cell, is too close to it.
  Interval too_close(double dy) const
  {
    Interval dx{-to_cell_x, to_cell_x};
    dx.cut(c, s * dy, along);
    dx.cut(-s, c * dy, across);
    return dx;
  }

  double c, s;
  double reach_x, reach_y;      ///< of the rectangle [m]
  double to_cell_x, to_cell_y;  ///< distances of the centres at which both touch, on the axes of the grid [m]
  double along, across;         ///< the same on those of the rectangle [m]
};

double RectangleFlood::half_step(const Robot& robot)
{
  const double corner = std::hypot(robot.length, robot.width) / 2.0;
  return std::max(kStep / 2.0, 2.0 * corner * std::sin(kTurn / 4.0));
}

RectangleFlood::RectangleFlood(const OccupancyGrid& grid, const ObstacleRule& rule, const Robot& robot, double margin)
  : columns_(static_cast<std::size_t>(grid.width * grid.resolution / kStep) + 1),
    rows_(static_cast<std::size_t>(grid.height * grid.resolution / kStep) + 1),
    width_(grid.width * grid.resolution),
    height_(grid.height * grid.resolution),
    component_(columns_ * rows_ * kHeadings, 0)
{
  for (std::size_t heading = 0; heading < kHalfTurn; ++heading)
  {
    const Shape shape(robot.length / 2.0 + margin, robot.width / 2.0 + margin, static_cast<double>(heading) * kTurn,
                      grid.resolution / 2.0);
    block_border(shape, heading);
    for (int row = 0; row < grid.height; ++row)
      for (int column = 0; column < grid.width; ++column)
        if (rule.is_obstacle(grid.at(column, row)))
          block_cell(shape, heading, (column + 0.5) * grid.resolution, (row + 0.5) * grid.resolution);
  }
  turn_half();
  label_components();
}

void RectangleFlood::block_border(const Shape& shape, std::size_t heading)
{
  for (std::size_t row = 0; row < rows_; ++row)
    for (std::size_t column = 0; column < columns_; ++column)
    {
      const double x = static_cast<double>(column) * kStep, y = static_cast<double>(row) * kStep;
      if (std::min(x, width_ - x) < shape.reach_x - kTouch || std::min(y, height_ - y) < shape.reach_y - kTouch)
        component_[index({column, row, heading})] = -1;
    }
}

void RectangleFlood::block_cell(const Shape& shape, std::size_t heading, double x, double y)
{
  const Lines rows(y - shape.to_cell_y, y + shape.to_cell_y, rows_);
  for (std::size_t row = rows.first; row < rows.end; ++row)
  {
    const Interval dx = shape.too_close(static_cast<double>(row) * kStep - y);
    if (dx.low >= dx.high) continue;
    const Lines columns(x + dx.low, x + dx.high, columns_);
    for (std::size_t column = columns.first; column < columns.end; ++column)
      component_[index({column, row, heading})] = -1;
  }
}

/// The headings of the other half turn: the rectangle is where it is at those of the first.
void RectangleFlood::turn_half()
{
  const auto half = component_.begin() + static_cast<std::ptrdiff_t>(component_.size() / 2);
  std::copy(component_.begin(), half, half);
}

void RectangleFlood::label_components()
{
  std::int32_t label = 0;
  for (std::size_t heading = 0; heading < kHeadings; ++heading)
    for (std::size_t row = 0; row < rows_; ++row)
      for (std::size_t column = 0; column < columns_; ++column)
        if (component_[index({column, row, heading})] == 0) fill({column, row, heading}, ++label);
}

void RectangleFlood::fill(const Place& from, std::int32_t label)
{
  std::vector<Place> found;
  const auto visit = [&](std::size_t column, std::size_t row, std::size_t heading) {
    if (column >= columns_ || row >= rows_) return;  // below 0 as well, for indices without sign
    std::int32_t& component = component_[index({column, row, heading})];
    if (component != 0) return;
    component = label;
    found.push_back({column, row, heading});
  };
  visit(from.column, from.row, from.heading);
  while (!found.empty())
  {
    const Place at = found.back();
    found.pop_back();
    visit(at.column + 1, at.row, at.heading);
    visit(at.column - 1, at.row, at.heading);
    visit(at.column, at.row + 1, at.heading);
    visit(at.column, at.row - 1, at.heading);
    visit(at.column, at.row, (at.heading + 1) % kHeadings);
    visit(at.column, at.row, (at.heading + kHeadings - 1) % kHeadings);
  }
}

RectangleFlood::Place RectangleFlood::place(const Pose& pose) const
{
  const double turn = pose.theta - 2.0 * M_PI * std::floor(pose.theta / (2.0 * M_PI));
  return {rounded(pose.x / kStep, columns_), rounded(pose.y / kStep, rows_),
          rounded(turn / kTurn, kHeadings + 1) % kHeadings};
}

Pose RectangleFlood::nearest(const Pose& pose) const
{
  const Place at = place(pose);
  return {static_cast<double>(at.column) * kStep, static_cast<double>(at.row) * kStep,
          wrap_angle(static_cast<double>(at.heading) * kTurn)};
}

bool RectangleFlood::joins(const Pose& start, const Pose& goal) const
{
  const std::int32_t component = component_[index(place(start))];
  return component > 0 && component == component_[index(place(goal))];
}

}  // namespace fourwis::nightly
