#include <algorithm>
#include <cmath>
#include <limits>

#include "lattice_flood.h"

namespace fourwis::nightly
{
namespace
{

constexpr double kTouch = 1e-9;   ///< less overlap than this is none [m]
constexpr double kBeyond = 10.0;  ///< how far what lies outside the grid reaches [m]

}  // namespace

double Lattice::turn() const
{
  return M_PI / headings;
}

/// Open at both ends.
struct FreePoses::Interval
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

/// A rectangle against a box, by the theorem of separating axes.
struct FreePoses::Rectangle
{
  double half_length, half_width;  ///< [m]
  double c, s;                     ///< cosine and sine of the heading

  double reach_x() const { return half_length * std::abs(c) + half_width * std::abs(s); }
  double reach_y() const { return half_length * std::abs(s) + half_width * std::abs(c); }
  double low_y(const Box& box) const { return box.bottom - reach_y(); }
  double high_y(const Box& box) const { return box.top + reach_y(); }

  Interval blocked(const Box& box, double y) const
  {
    const double half_x = (box.right - box.left) / 2.0, half_y = (box.top - box.bottom) / 2.0;
    const double x = (box.left + box.right) / 2.0, dy = y - (box.bottom + box.top) / 2.0;
    Interval dx{kTouch - reach_x() - half_x, reach_x() + half_x - kTouch};
    dx.cut(c, s * dy, half_length + half_x * std::abs(c) + half_y * std::abs(s) - kTouch);
    dx.cut(-s, c * dy, half_width + half_x * std::abs(s) + half_y * std::abs(c) - kTouch);
    return {x + dx.low, x + dx.high};
  }
};

/// A disc, beside the pose, against a box.
struct FreePoses::Disc
{
  double x, y, radius;  ///< its centre from that of the pose

  double low_y(const Box& box) const { return box.bottom - radius - y; }
  double high_y(const Box& box) const { return box.top + radius - y; }

  Interval blocked(const Box& box, double pose_y) const
  {
    const double beside = std::max({0.0, box.bottom - (pose_y + y), pose_y + y - box.top});
    if (beside >= radius) return {0.0, 0.0};
    const double reach = std::sqrt(radius * radius - beside * beside) - kTouch;
    return {box.left - reach - x, box.right + reach - x};
  }
};

FreePoses::FreePoses(const OccupancyGrid& grid, const Lattice& lattice)
  : lattice_(lattice),
    columns_(static_cast<int>(grid.width * grid.resolution / lattice.step + 1e-9) + 1),
    rows_(static_cast<int>(grid.height * grid.resolution / lattice.step + 1e-9) + 1),
    words_((columns_ + 63) / 64)
{
  bits_.assign(index(lattice.headings, 0, 0), ~std::uint64_t{0});
  if (const int used = columns_ % 64; used > 0)
    for (std::size_t last = static_cast<std::size_t>(words_) - 1; last < bits_.size();
         last += static_cast<std::size_t>(words_))
      bits_[last] = (std::uint64_t{1} << used) - 1;
  // Runs of cells in a row, and those of equal ends above one another, are one box.
  const double r = grid.resolution;
  const ObstacleRule rule;
  std::vector<Box> below, here;
  for (int row = 0; row < grid.height; ++row)
  {
    here.clear();
    for (int column = 0; column < grid.width; ++column)
    {
      if (!rule.is_obstacle(grid.at(column, row))) continue;
      const int first = column;
      while (column < grid.width && rule.is_obstacle(grid.at(column, row))) ++column;
      Box box{first * r, column * r, row * r, (row + 1) * r};
      for (Box& other : below)
        if (other.left == box.left && other.right == box.right)
        {
          box.bottom = other.bottom;
          other.left = other.right;  // taken
          break;
        }
      here.push_back(box);
    }
    for (const Box& box : below)
      if (box.left < box.right) obstacles_.push_back(box);
    below = here;
  }
  obstacles_.insert(obstacles_.end(), below.begin(), below.end());
  const double width = grid.width * r, height = grid.height * r;
  obstacles_.push_back({-kBeyond, 0.0, -kBeyond, height + kBeyond});
  obstacles_.push_back({width, width + kBeyond, -kBeyond, height + kBeyond});
  obstacles_.push_back({-kBeyond, width + kBeyond, -kBeyond, 0.0});
  obstacles_.push_back({-kBeyond, width + kBeyond, height, height + kBeyond});
}

FreePoses FreePoses::of_rectangle(const OccupancyGrid& grid, const Lattice& lattice, const Robot& robot, double margin,
                                  Edge edge)
{
  FreePoses poses(grid, lattice);
  const double half_length = robot.length / 2.0 + margin, half_width = robot.width / 2.0 + margin;
  for (int heading = 0; heading < lattice.headings; ++heading)
  {
    const double c = std::cos(heading * lattice.turn()), s = std::sin(heading * lattice.turn());
    Rectangle shape{half_length, half_width, c, s};
    if (edge == Edge::inner)
    {
      // One coordinate changes at a time: no point of the body is farther than this from where it is at one of the neighbours.
      const double corner = std::hypot(half_length, half_width);
      const double grow = std::max(lattice.step / 2.0, 2.0 * corner * std::sin(lattice.turn() / 4.0));
      shape.half_length += grow;
      shape.half_width += grow;
    }
    else
    {
      // What the body covers at all poses around this one: half a step on both axes, half a turn of the lattice either way.
      const double turned = std::sin(lattice.turn() / 2.0);
      const double moved = lattice.step / 2.0 * (std::abs(c) + std::abs(s));
      shape.half_length = std::max(0.0, half_length - half_width * turned - moved);
      shape.half_width = std::max(0.0, half_width - half_length * turned - moved);
    }
    poses.block(heading, shape);
  }
  return poses;
}

FreePoses FreePoses::of_discs(const OccupancyGrid& grid, const Lattice& lattice, const Robot& robot)
{
  FreePoses poses(grid, lattice);
  const double offset = robot.length / 4.0;
  const double radius = std::hypot(robot.length / 4.0, robot.width / 2.0) + robot.safety_margin;
  for (int heading = 0; heading < lattice.headings; ++heading)
  {
    const double c = std::cos(heading * lattice.turn()), s = std::sin(heading * lattice.turn());
    poses.block(heading, Disc{offset * c, offset * s, radius});
    poses.block(heading, Disc{-offset * c, -offset * s, radius});
  }
  return poses;
}

template <class Shape>
void FreePoses::block(int heading, const Shape& shape)
{
  for (const Box& box : obstacles_)
  {
    const int first = std::max(0, static_cast<int>(std::floor(shape.low_y(box) / lattice_.step)));
    const int last = std::min(rows_ - 1, static_cast<int>(std::ceil(shape.high_y(box) / lattice_.step)));
    for (int row = first; row <= last; ++row)
    {
      const double y = row * lattice_.step;
      if (y <= shape.low_y(box) + kTouch || y >= shape.high_y(box) - kTouch) continue;
      const Interval x = shape.blocked(box, y);
      if (x.low < x.high) block(heading, row, x.low, x.high);
    }
  }
}

/// The columns strictly between two x.
void FreePoses::block(int heading, int row, double low, double high)
{
  const int first = static_cast<int>(std::max(0.0, std::floor(low / lattice_.step) + 1.0));
  const int last = static_cast<int>(std::min(columns_ - 1.0, std::ceil(high / lattice_.step) - 1.0));
  for (int word = first / 64; first <= last && word <= last / 64; ++word)
  {
    const int from = std::max(first - 64 * word, 0), to = std::min(last - 64 * word, 63);
    bits_[index(heading, row, word)] &= ~((~std::uint64_t{0} >> (63 - (to - from))) << from);
  }
}

std::pair<std::size_t, std::uint64_t> FreePoses::at(const Pose& pose) const
{
  const auto nearest = [](double value, int count) {
    return std::clamp(static_cast<int>(std::lround(value)), 0, count - 1);
  };
  const int column = nearest(pose.x / lattice_.step, columns_), row = nearest(pose.y / lattice_.step, rows_);
  const long turns = std::lround(pose.theta / lattice_.turn());
  const int heading = static_cast<int>((turns % lattice_.headings + lattice_.headings) % lattice_.headings);
  return {index(heading, row, column / 64), std::uint64_t{1} << (column % 64)};
}

}  // namespace fourwis::nightly
