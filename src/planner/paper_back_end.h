#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/corridor/box_corridor.h"
#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/segment.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/optimize/paper_optimizer.h"
#include "fourwis_navigation/vehicle/footprint.h"
#include "plan_context.h"

namespace fourwis
{

struct PaperBackEndOptions
{
  double spacing = 0.2;       ///< D [m]
  BoxOptions boxes;           ///< Algorithm 2
  PaperOptions program;       ///< eq. (26)
  double convergence = 1e-6;  ///< epsilon_tol: done when psi is less
  int outer_iterations = 10;  ///< I, at most so many rounds of corridor and program

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("spacing", o.spacing, 0.01, 10.0, "m");
    row.group("", o.boxes);
    row.group("", o.program);
    row("convergence", o.convergence, 1e-12, 1.0);
    row("outer_iterations", o.outer_iterations, 1, 1000);
  }
};

/// Throws std::invalid_argument naming key, value and range, and as the checks of its parts do.
void check(const PaperBackEndOptions& options);

enum class PaperStatus
{
  converged,      ///< psi < convergence in every segment
  not_converged,  ///< the rounds are used up; the trajectory is the last iterate
  corridor,       ///< no boxes around the path or an iterate; the trajectory lacks that segment if there was no iterate
  interrupted,    ///< the trajectory may be incomplete
  invalid_path    ///< nothing to drive, or an unusable path
};

const char* to_string(PaperStatus status);

/// What the paper's back end made of a path.
struct PaperRefinement
{
  PaperStatus status = PaperStatus::invalid_path;  ///< of the first segment that did not converge
  std::string message;                             ///< one sentence with numbers, for a person
  Trajectory trajectory;                           ///< of the whole path, Euler steps
  int segments = 0;
  int outer_iterations = 0;            ///< most of all segments
  int ipopt_iterations = 0;            ///< sum over segments and rounds
  double infeasibility = 0.0;          ///< psi, greatest of all segments
  std::vector<BoxCorridor> corridors;  ///< the last of each segment
};

/// The paper's section III-B as it stands, for comparison with BackEnd: the path is split at its switches (22); each
/// segment goes through boxes around the current solution <-> the program (26), begun at that solution, until
/// psi < 1e-6 or for 10 rounds; the parts are joined with t_switch in between (23). The steps are Euler's and boxes
/// bind the knots only: that the referee accepts the trajectory is not promised.
class PaperBackEnd
{
public:
  /// Of the context's options only the reference speed counts. Throws std::invalid_argument naming the option, or the
  /// reference speed, if one is out of range.
  explicit PaperBackEnd(const PlanContext& context, const PaperBackEndOptions& options = PaperBackEndOptions());

  /// Throws likewise, never on a path.
  PaperRefinement refine(const Path& path) const;

private:
  struct Outcome;

  Outcome refine(const Segment& segment) const;
  void iterate(const Segment& segment, Outcome& outcome) const;

  const PlanContext context_;
  const PaperBackEndOptions options_;
  const TwoDiscs discs_;
  const PaperOptimizer optimizer_;
};

}  // namespace fourwis
