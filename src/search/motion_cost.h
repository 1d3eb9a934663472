#pragma once

#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/search/search_options.h"

namespace fourwis
{

/// The costs of the search, in metres: paper eq. (15) and (16). The paper has terms per primitive of length v_ref dt.
/// Here they are in proportion to the length, so that pieces of any length can be compared. A metre that the wheels cannot
/// drive at v_ref costs as many more as it takes longer.
class MotionCost
{
public:
  MotionCost(const Robot& robot, const SearchOptions& options);

  /// Cost of driving a piece after `previous`, which may be null (at the start, or just after a switch at rest, when the
  /// wheels have been turned already).
  double piece(const PathPiece& piece, const PathPiece* previous) const;

  /// C_switch; the velocity term is halved at the start, where the robot is at rest anyway. Zero without switching
  /// awareness.
  double mode_switch(bool at_start) const { return at_start ? switch_at_start_ : switch_; }

private:
  double slowness(Mode mode, double phi) const;

  const Robot& robot_;
  const SearchOptions& options_;
  double v_ref_;
  double per_metre_;
  PerMode<double> straight_, at_lock_;  ///< slowness at phi = 0, and at the greatest
  PerMode<double> greatest_phi_;
  double switch_;
  double switch_at_start_;
};

}  // namespace fourwis
