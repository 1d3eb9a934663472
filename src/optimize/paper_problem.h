#pragma once

#include <array>
#include <vector>

#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/segment.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/optimize/paper_optimizer.h"
#include "motion_limits.h"
#include "nlp.h"
#include "paper_discs.h"
#include "paper_step.h"

namespace fourwis
{

/// The program of PaperOptimizer.
class PaperProblem
{
public:
  /// From `previous`, or from the reference where it is null. The sizes must fit.
  PaperProblem(const Segment& segment, const BoxCorridor& boxes, const Robot& robot, const PaperOptions& options,
               const MotionLimits& limits, const Trajectory* previous);

  const Nlp& nlp() const { return nlp_; }

  /// What the program's variables mean.
  Trajectory points(const std::vector<double>& x) const;

private:
  using State = std::array<int, EulerDynamics::kStates>;

  void add_states(const Trajectory& guess, const TrajectoryPoint& start, const TrajectoryPoint& goal,
                  const MotionLimits& limits);
  void add_controls(const Trajectory& guess, const MotionLimits& limits);

  const Mode mode_;
  Nlp nlp_;
  std::vector<State> states_;                 ///< indices of each knot's (x, y, theta, v, phi)
  std::vector<std::array<int, 2>> controls_;  ///< indices of each step's (a, omega)
  int duration_ = 0;                          ///< index of T
};

/// psi of points that are equally far apart in time. The disc centres of the inner knots are at their best places in
/// their boxes.
double paper_infeasibility(const Trajectory& points, const BoxCorridor& boxes, const Robot& robot);

}  // namespace fourwis
