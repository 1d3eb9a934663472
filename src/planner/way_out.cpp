#include "way_out.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/map/body_overlap.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_limits.h"
#include "fourwis_navigation/vehicle/mode_traits.h"

namespace fourwis
{
namespace
{

/// Lines along which a body that keeps its heading is tried, forward and backward.
constexpr int kLines = 16;
/// Length of the longest motion, in sizes of the robot.
constexpr double kLongest = 0.5;
/// Between two looks at the body [m].
constexpr double kStep = 0.002;
/// What the body keeps at the end, so that a search can begin there [m].
constexpr double kWanted = 0.003;

/// Motions in which the wheels are held still.
std::vector<PathPiece> motions(const Robot& robot, const Pose& pose, const ModeSet& modes)
{
  const DriveLimits limits(robot);
  std::vector<PathPiece> pieces;
  for (Mode mode : kPlannedModes)
  {
    if (!modes.contains(mode) || !limits[mode].possible) continue;
    if (traits_of(mode).follows_phi)
      for (int k = 0; k < kLines; ++k)
      {
        const double phi = wrap_angle(M_PI * k / kLines);
        const double angle = phi > M_PI_2 ? phi - M_PI : phi;
        if (std::abs(angle) > limits[mode].phi) continue;
        pieces.push_back({mode, pose, angle, 1.0});
        pieces.push_back({mode, pose, angle, -1.0});
      }
    else
      for (double phi : {0.0, limits[mode].phi, -limits[mode].phi})
      {
        pieces.push_back({mode, pose, phi, 1.0});
        pieces.push_back({mode, pose, phi, -1.0});
      }
  }
  return pieces;
}

/// Length of the motion at which the body is free, at most `longest`; nothing where it goes deeper before.
std::optional<double> length_to_freedom(const World& world, const PathPiece& piece, double longest)
{
  const ConvexPolygon body = body_of(world.robot);
  const Arc arc(world.robot, piece.start, piece.mode, piece.phi);
  double before = body_clearance(world.obstacles, body, piece.start, kWanted);
  for (double length = kStep; length < longest; length += kStep)
  {
    const double clearance =
        body_clearance(world.obstacles, body, arc.pose(std::copysign(length, piece.length)), kWanted);
    if (clearance < before) return std::nullopt;
    if (clearance >= kWanted) return length;
    before = clearance;
  }
  return std::nullopt;
}

}  // namespace

std::optional<PathPiece> way_out(const World& world, const Pose& pose, const ModeSet& modes)
{
  std::optional<PathPiece> best;
  double longest = kLongest * world.robot.size();
  for (PathPiece& piece : motions(world.robot, pose, modes))
    if (const std::optional<double> length = length_to_freedom(world, piece, longest))
    {
      longest = *length;
      piece.length = std::copysign(*length, piece.length);
      best = piece;
    }
  return best;
}

}  // namespace fourwis
