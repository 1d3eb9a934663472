#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Checks the exact rectangle of the body against the square of each occupied cell, with the theorem of separating
/// axes.
class ExactRectangle
{
public:
  ExactRectangle(const OccupancyGrid& grid, const Robot& robot, const ObstacleRule& rule = {})
    : grid_(grid),
      half_length_(robot.length / 2.0),
      half_width_(robot.width / 2.0)
  {
    for (int row = 0; row < grid.height; ++row)
      for (int column = 0; column < grid.width; ++column)
        if (rule.is_obstacle(grid.at(column, row)))
          obstacles_.push_back({(column + 0.5) * grid.resolution, (row + 0.5) * grid.resolution});
  }

  /// Whether the interior of the rectangle meets an obstacle or leaves the grid. 1 nm of overlap still counts as
  /// touching.
  bool collides(const Pose& pose) const
  {
    const Pose body = relative_to(grid_.origin, pose);
    const double c = std::cos(body.theta), s = std::sin(body.theta);
    const double reach_x = half_length_ * std::abs(c) + half_width_ * std::abs(s);
    const double reach_y = half_length_ * std::abs(s) + half_width_ * std::abs(c);
    if (body.x - reach_x < -kTouch || body.x + reach_x > grid_.width * grid_.resolution + kTouch) return true;
    if (body.y - reach_y < -kTouch || body.y + reach_y > grid_.height * grid_.resolution + kTouch) return true;
    const double half = grid_.resolution / 2.0, half_diagonal = half * (std::abs(c) + std::abs(s));
    return std::any_of(obstacles_.begin(), obstacles_.end(), [&](const std::array<double, 2>& centre) {
      const double dx = centre[0] - body.x, dy = centre[1] - body.y;
      return std::abs(dx) < reach_x + half - kTouch && std::abs(dy) < reach_y + half - kTouch &&
             std::abs(c * dx + s * dy) < half_length_ + half_diagonal - kTouch &&
             std::abs(c * dy - s * dx) < half_width_ + half_diagonal - kTouch;
    });
  }

  /// By how much each side of the rectangle has to be moved inward until it is clear of obstacles and within the grid [m];
  /// 0 where it is.
  double depth(const Pose& pose) const
  {
    const Pose body = relative_to(grid_.origin, pose);
    const double c = std::abs(std::cos(body.theta)), s = std::abs(std::sin(body.theta));
    const double reach_x = half_length_ * c + half_width_ * s, reach_y = half_length_ * s + half_width_ * c;
    const double right = grid_.width * grid_.resolution - body.x, top = grid_.height * grid_.resolution - body.y;
    // Moved inward by d, the rectangle reaches d (c + s) less along each axis of the grid.
    double deepest =
        std::max({0.0, (reach_x - std::min(body.x, right)) / (c + s), (reach_y - std::min(body.y, top)) / (c + s)});
    const double half = grid_.resolution / 2.0, half_diagonal = half * (c + s);
    for (const std::array<double, 2>& centre : obstacles_)
    {
      const double dx = centre[0] - body.x, dy = centre[1] - body.y;
      const double along = std::abs(std::cos(body.theta) * dx + std::sin(body.theta) * dy);
      const double across = std::abs(std::cos(body.theta) * dy - std::sin(body.theta) * dx);
      // The first axis that separates the two.
      deepest = std::max(
          deepest, std::min({half_length_ + half_diagonal - along, half_width_ + half_diagonal - across,
                             (reach_x + half - std::abs(dx)) / (c + s), (reach_y + half - std::abs(dy)) / (c + s)}));
    }
    return deepest;
  }

private:
  static constexpr double kTouch = 1e-9;

  const OccupancyGrid& grid_;
  double half_length_, half_width_;
  std::vector<std::array<double, 2>> obstacles_;  ///< centres, in the grid's frame
};

}  // namespace fourwis
