#include "fourwis_navigation/optimize/ipopt_segment_optimizer.h"

#include <algorithm>

#include "fourwis_navigation/model/option_check.h"
#include "ipopt_solver.h"
#include "motion_limits.h"
#include "ocp_nlp.h"
#include "segment_problem.h"

namespace fourwis
{
namespace
{

bool fits(const SegmentTask& task)
{
  const Segment& segment = task.segment;
  const std::size_t n = segment.intervals();
  return n > 0 && segment.knots.size() == n + 1 && segment.length.size() == n && !task.corridor.empty() &&
         std::all_of(task.corridor.begin(), task.corridor.end(),
                     [n](const DiscRegions& disc) { return disc.regions.size() == n; }) &&
         (!task.previous || task.previous->size() == n + 1) && (task.pinned.empty() || task.pinned.size() == n + 1) &&
         is_planned(segment.mode);
}

}  // namespace

IpoptSegmentOptimizer::IpoptSegmentOptimizer(const Robot& robot, const OptimizeOptions& options, double reference_speed)
  : robot_(checked(robot)),
    options_(checked(options)),
    reference_speed_(reference_speed)
{
  require_positive("reference_speed", reference_speed);
}

SegmentSolution IpoptSegmentOptimizer::solve(const SegmentTask& task, double tolerance,
                                             const Interrupt& interrupt) const
{
  SegmentSolution result;
  result.message = to_string(NlpStatus::invalid_problem);
  if (!fits(task)) return result;

  const Segment& segment = task.segment;
  const MotionLimits limits(robot_, segment.mode);
  const auto problem = segment_problem<WheelSpeedRows>(task, robot_, options_, limits, reference_speed_);
  const OcpNlp<SegmentModel<WheelSpeedRows>> program(
      problem.model, problem.numbers,
      task.previous ? guess_from(*task.previous) : reference_guess(segment, limits, problem.model.h_ref));
  IpoptOptions solver_options;
  solver_options.tolerance = tolerance;
  const NlpResult solution = solve_on_ipopt(program.nlp(), solver_options, interrupt);

  result.solved = is_solved(solution.status);
  result.message = to_string(solution.status);
  result.points = points_of(program.trajectory(solution.x), segment.mode);
  result.iterations = solution.iterations;
  result.corridor_violation = program.greatest_excess(solution.x);
  return result;
}

}  // namespace fourwis
