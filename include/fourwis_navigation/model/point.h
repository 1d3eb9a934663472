#pragma once

namespace fourwis
{

/// A point of the plane [m].
struct Point2
{
  double x, y;
};

}  // namespace fourwis
