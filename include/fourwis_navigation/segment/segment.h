#pragma once

#include <vector>

#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/segment.h"

namespace fourwis
{

/// Splits a path where the mode changes and resamples each part as a reference for the optimisation.
///
/// Every run (stretch of one driving direction) is cut into at least four intervals of equal length, none longer than
/// `spacing` [m]. Four are needed because from rest to rest the speed has the slopes + + - - and the steering angle + -
/// - +, and an interval has one slope of each. Knots lie on the path's exact arcs. If the wheels turn within an
/// interval, its angle is the mean by length. Headings are continuous from the first segment to the last.
///
/// In parallel mode (phi, s) and (phi +- pi, -s) are the same motion. Within a segment each piece takes the angle
/// nearest to that of the piece before it, as far as the wheels' travel allows. So phi may leave [-pi/2, pi/2], and a
/// sharp corner becomes a cusp.
///
/// Pieces shorter than a micrometre are dropped, and so is a segment that has no others. The result is empty when there
/// is no motion at all, or when the path is unusable: a number is not finite, a mode is not planned, pieces lie more
/// than 1 mm or 1 mrad apart, there would be more than a million intervals. Throws std::invalid_argument unless
/// `spacing` is positive and finite.
std::vector<Segment> split_at_switches(const Path& path, const Robot& robot, double spacing);

/// Length of the way of C, the centre of the wheels [m].
double travel_length(const Segment& segment);

/// T = L / v_ref [s], the paper's initial duration of a segment. Throws std::invalid_argument unless `v_ref` is
/// positive and finite.
double reference_duration(const Segment& segment, double v_ref);

}  // namespace fourwis
