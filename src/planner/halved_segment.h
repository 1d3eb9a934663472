#pragma once

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/segment.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// The solution of a segment with twice the knots: each interval is cut in two where half of its time is over.
struct HalvedSegment
{
  HalvedSegment(const Robot& robot, const Trajectory& solution);

  Trajectory points;  ///< the same motion
  Segment reference;  ///< the same as a reference
};

}  // namespace fourwis
