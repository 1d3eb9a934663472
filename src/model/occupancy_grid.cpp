#include "fourwis_navigation/model/occupancy_grid.h"

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{

void check(const ObstacleRule& rule)
{
  check_ranges(rule);
}

}  // namespace fourwis
