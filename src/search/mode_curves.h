#pragma once

#include <array>
#include <vector>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/search/search_options.h"
#include "fourwis_navigation/vehicle/mode_limits.h"
#include "fourwis_navigation/vehicle/mode_traits.h"
#include "motion_cost.h"

namespace fourwis
{

/// A curve from one pose to another, obstacles not considered.
struct ModeCurve
{
  static constexpr int kMaxPieces = 6;
  std::array<PathPiece, kMaxPieces> pieces;  ///< `start` is unset until place() is called
  int count = 0;
  double cost = 0.0;  ///< of the pieces and of the switches before and between them

  void append(Mode mode, double phi, double length)
  {
    pieces[static_cast<std::size_t>(count++)] = {mode, {}, phi, length};
  }
};

/// The multi-modal Reeds-Shepp curves of the paper's section III-A.2 and curves of two modes: an arc that turns the robot to
/// the goal's heading and a parallel straight line, in either order.
class ModeCurves
{
public:
  /// Parallel motion cannot turn, so it connects only poses of one heading; this much rounding is passed over [rad].
  static constexpr double kSameHeading = 1e-4;

  /// Keeps references: all must outlive this object.
  ModeCurves(const Robot& robot, const SearchOptions& options, const MotionCost& cost, const ModeSet& modes);

  const MotionCost& cost() const { return cost_; }
  const ModeSet& modes() const { return modes_; }

  /// Where a curve begins: the mode the robot is in, the piece driven before (null at the start and after a switch),
  /// and whether it is the start of the whole path, where a switch costs less.
  struct Situation
  {
    Mode mode = Mode::none;
    const PathPiece* previous = nullptr;
    bool at_start = false;
  };

  /// Every candidate that costs less than `budget` from `from` to `goal`, cheapest first.
  void candidates(const Pose& from, const Situation& situation, const Pose& goal, double budget,
                  std::vector<ModeCurve>& curves) const;

  /// Sets the start poses of a curve's pieces from the pose of the first one.
  void place(const Pose& from, ModeCurve& curve) const;

  /// Where a piece ends.
  Pose end_of(const PathPiece& piece) const;

  /// Least length of curves to the goal, with C_switch for each switch [m]: the bracket of paper eq. (17). Infinite where
  /// no mode gets there.
  double length_with_switches(const Pose& from, Mode mode, const Pose& goal) const;

private:
  /// Whether curves may have arcs of a mode, and whether they may have straight lines in any direction.
  bool may_turn_in(Mode mode) const { return modes_.contains(mode) && limits_[mode].curvature > 0.0; }
  bool may_translate() const { return modes_.contains(kTranslation); }

  void append_reeds_shepp(const Pose& relative, Mode mode, double longest, std::vector<ModeCurve>& curves) const;
  bool append_straight(double x, double y, ModeCurve& curve) const;
  void append_translation(const Pose& relative, std::vector<ModeCurve>& curves) const;
  void append_turn_and_translate(const Pose& relative, Mode turning, std::vector<ModeCurve>& curves) const;
  double curve_cost(const ModeCurve& curve, const Situation& situation) const;

  const Robot& robot_;
  const DriveLimits limits_;
  const SearchOptions& options_;
  const MotionCost& cost_;
  const ModeSet& modes_;
};

/// Whether all pieces of a placed curve are free.
bool is_free(const CollisionChecker& checker, const ModeCurve& curve);

}  // namespace fourwis
