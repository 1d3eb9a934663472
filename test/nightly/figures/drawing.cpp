#include "drawing.h"

namespace fourwis::nightly
{

void Drawing::box(double left, double bottom, double right, double top, bool occupied)
{
  const double r = grid_.resolution;
  const auto line = [&](double value, int count) {
    return std::clamp(static_cast<int>(std::lround(value / r)), 0, count);
  };
  const int first_column = line(left, grid_.width), first_row = line(bottom, grid_.height);
  const int columns = std::max(line(right, grid_.width), std::min(first_column + 1, grid_.width));
  const int rows = std::max(line(top, grid_.height), std::min(first_row + 1, grid_.height));
  for (int row = first_row; row < rows; ++row)
    for (int column = first_column; column < columns; ++column) occupy(grid_, column, row, occupied ? 100 : 0);
}

void Drawing::rectangle(const Pose& middle, double length, double width)
{
  const double r = grid_.resolution, reach = std::hypot(length, width) / 2.0;
  const auto cell_at = [&](double value, int count) { return std::clamp(static_cast<int>(value / r), 0, count - 1); };
  for (int row = cell_at(middle.y - reach, grid_.height); row <= cell_at(middle.y + reach, grid_.height); ++row)
    for (int column = cell_at(middle.x - reach, grid_.width); column <= cell_at(middle.x + reach, grid_.width);
         ++column)
    {
      const Pose at = relative_to(middle, {(column + 0.5) * r, (row + 0.5) * r, 0.0});
      if (std::abs(at.x) <= length / 2.0 && std::abs(at.y) <= width / 2.0) occupy(grid_, column, row);
    }
}

void Drawing::disc(double x, double y, double radius)
{
  const double r = grid_.resolution;
  for (int row = 0; row < grid_.height; ++row)
    for (int column = 0; column < grid_.width; ++column)
      if (std::hypot((column + 0.5) * r - x, (row + 0.5) * r - y) <= radius) occupy(grid_, column, row);
}

void Drawing::frame(double thickness)
{
  box(0.0, 0.0, length(), thickness);
  box(0.0, width() - thickness, length(), width());
  box(0.0, 0.0, thickness, width());
  box(length() - thickness, 0.0, length(), width());
}

}  // namespace fourwis::nightly
