#include "fourwis_navigation/model/robot.h"

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{
namespace
{

/// A wheel outside the rectangle length x width would be invisible to every collision check.
void check_axis_inside(const char* axis, double distance, const char* side, double extent)
{
  if (distance <= extent) return;
  reject_option(axis, to_text(distance),
                std::string("at most '") + side + "' (" + to_text(extent) +
                    " m): the wheels must lie within the body's rectangle");
}

}  // namespace

void check(const Robot& robot)
{
  check_ranges(robot);
  check_axis_inside("wheelbase", robot.wheelbase, "length", robot.length);
  check_axis_inside("track_width", robot.track_width, "width", robot.width);
}

}  // namespace fourwis
