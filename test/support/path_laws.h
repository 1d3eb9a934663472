#pragma once

#include <string>
#include <vector>

#include "drive.h"
#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/path.h"
#include "random.h"
#include "search/motion_cost.h"

namespace fourwis
{

inline std::string text(const PathPiece& piece)
{
  return std::string(to_string(piece.mode)) + " from " + text(piece.start) + " phi " + std::to_string(piece.phi) +
         " length " + std::to_string(piece.length);
}

inline std::string text(const Path& path)
{
  std::string lines;
  for (const PathPiece& piece : path.pieces) lines += "  " + text(piece) + "\n";
  return lines + "  to " + text(path.goal) + " for " + std::to_string(path.cost) + "\n";
}

/// Costs of a path that starts at rest in `mode`, one piece after the other: paper eq. (15) and (16).
inline double cost_of(const std::vector<PathPiece>& pieces, Mode mode, const MotionCost& cost)
{
  double sum = 0.0;
  const PathPiece* previous = nullptr;
  for (const PathPiece& piece : pieces)
  {
    if (piece.mode != mode)
    {
      sum += cost.mode_switch(&piece == &pieces.front());
      previous = nullptr;
    }
    sum += cost.piece(piece, previous);
    mode = piece.mode;
    previous = &piece;
  }
  return sum;
}

inline bool is_bitwise_equal(const Pose& a, const Pose& b)
{
  return a.x == b.x && a.y == b.y && a.theta == b.theta;
}

inline bool is_bitwise_equal(const Path& a, const Path& b)
{
  if (a.pieces.size() != b.pieces.size() || a.cost != b.cost || !is_bitwise_equal(a.goal, b.goal)) return false;
  for (std::size_t i = 0; i < a.pieces.size(); ++i)
  {
    const PathPiece &p = a.pieces[i], &q = b.pieces[i];
    if (p.mode != q.mode || p.phi != q.phi || p.length != q.length || !is_bitwise_equal(p.start, q.start)) return false;
  }
  return true;
}

/// What is wrong with a path, by the rules for paths alone: no gaps, steering angles the robot has, allowed modes, no
/// collision. Empty when nothing is.
inline std::string broken_law(const Path& path, const CollisionChecker& checker, const Robot& robot,
                              const ModeSet& modes)
{
  for (std::size_t i = 0; i < path.pieces.size(); ++i)
  {
    const PathPiece& piece = path.pieces[i];
    const std::string where = "piece " + std::to_string(i) + " (" + text(piece) + ") ";
    const double limit = piece.mode == Mode::parallel ? M_PI : robot.max_steering_angle;
    if (!modes.contains(piece.mode)) return where + "is of a mode not allowed";
    if (!(std::abs(piece.phi) <= limit + 1e-12)) return where + "has an impossible steering angle";
    if (!checker.is_free(piece.start)) return where + "starts in collision";
    if (!checker.is_free(piece)) return where + "is in collision";
    const Pose end = drive_numerically(robot, piece.start, piece.mode, piece.phi, piece.length);
    const Pose& next = i + 1 < path.pieces.size() ? path.pieces[i + 1].start : path.goal;
    // Headings must not jump, not even by a full turn.
    if (distance(end, next) > 1e-9 || std::abs(end.theta - next.theta) > 1e-9)
      return where + "ends at " + text(end) + " and the next one starts at " + text(next);
  }
  return {};
}

/// Checks that, and start and goal.
inline std::string broken_law(const Path& path, const CollisionChecker& checker, const Robot& robot,
                              const ModeSet& modes, const Pose& start, const Pose& goal)
{
  if (path.pieces.empty()) return "there is no piece";
  if (!is_bitwise_equal(path.pieces.front().start, start)) return "it starts at " + text(path.pieces.front().start);
  if (distance(path.goal, goal) > 1e-6 || heading_gap(path.goal.theta, goal.theta) > 1e-6)
    return "it ends at " + text(path.goal) + ", not at " + text(goal);
  return broken_law(path, checker, robot, modes);
}

}  // namespace fourwis
