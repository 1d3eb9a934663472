#pragma once

#include <optional>

#include "fourwis_navigation/model/option_text.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Whether the library was built with Ipopt (FOURWIS_IPOPT). Without it NlpSolver::ipopt and Formulation::paper are rejected.
bool has_ipopt();

/// What solves a segment's problem.
enum class NlpSolver
{
  structured,  ///< ocp: milliseconds
  ipopt        ///< the same problem, some ten times slower
};

/// Which problem is solved for a segment.
enum class Formulation
{
  standard,  ///< SegmentOptimizer's
  paper      ///< PaperOptimizer's, on Ipopt only, with the paper's own numbers in place of those below
};

/// The back end's parameters; see doc/notation.md for the paper's symbols.
struct OptimizeOptions
{
  NlpSolver solver = NlpSolver::structured;
  Formulation formulation = Formulation::standard;
  std::optional<double> spacing;   ///< D, distance between knots of the reference [m]
  double steering_comfort = 0.02;  ///< alpha, weight of (v omega)^2 over time
  double interval_weight = 0.2;    ///< w_h, weight of (h_k - h_ref)^2, keeps the knots evenly spread in time [1/s]
  double corridor_weight = 100.0;  ///< what a metre outside the corridor costs [s/m]
  double shortest_interval = 0.1;  ///< least h_k, of h_ref
  double longest_interval = 1.5;   ///< greatest h_k, of h_ref, and greatest way within an interval, of the spacing
  double longest_at_rest = 4.0;    ///< the same next to knots at rest
  int corridor_discs = 2;          ///< discs that cover the body, each with a region of its own
  int polish_discs = 4;            ///< the same in the last, finer round
  std::optional<double> corridor_range;  ///< a corridor's polytopes reach this far beyond the reference [m]
  int outer_iterations = 2;              ///< rounds of corridor and optimisation, the last to full accuracy
  int repairs = 3;                       ///< further rounds with smaller regions where the certificate fails

  // What is not set is in proportion to the size of the robot.
  double knot_spacing(const Robot& robot) const { return spacing.value_or(0.2 * robot.motion_size()); }
  double range(const Robot& robot) const { return corridor_range.value_or(2.0 * robot.size()); }

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("solver", o.solver, OneOf{"structured", "ipopt"});
    row("formulation", o.formulation, OneOf{"default", "paper"});
    row("knot_spacing", o.spacing, 0.01, 2.0, "m", "from the robot's size and turns");
    row("steering_comfort", o.steering_comfort, 0.0, 100.0);
    row("interval_weight", o.interval_weight, 0.0, 100.0, "1/s");
    row("corridor_weight", o.corridor_weight, 1.0, 1e6, "s/m");
    row("shortest_interval", o.shortest_interval, 0.01, 0.9);
    row("longest_interval", o.longest_interval, 1.1, 100.0);
    row("longest_at_rest", o.longest_at_rest, 2.0, 100.0);
    row("corridor_discs", o.corridor_discs, 1, 8);
    row("polish_discs", o.polish_discs, 1, 8);
    row("corridor_range", o.corridor_range, 0.1, 20.0, "m", "twice the body's longer side");
    row("outer_iterations", o.outer_iterations, 1, 20);
    row("repairs", o.repairs, 0, 20);
  }
};

/// Throws std::invalid_argument naming key, value and range.
void check(const OptimizeOptions& options);

}  // namespace fourwis
