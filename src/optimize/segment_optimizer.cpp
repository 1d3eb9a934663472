#include "fourwis_navigation/optimize/segment_optimizer.h"

#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/ocp/solver.h"
#include "motion_limits.h"
#include "segment_problem.h"

namespace fourwis
{
namespace
{

/// Barrier parameter at the start and iterations of a solve.
struct Effort
{
  double barrier;
  int iterations;
};

/// From the reference. Most solves take 10 to 50 iterations; long lateral segments at full lock sometimes take 150.
constexpr Effort kCold{0.1, 300};
/// From a solution of nearly the same problem. The second is tried if the first, quick one fails.
constexpr Effort kWarm[] = {{1e-3, 60}, {1e-2, 300}};

template <class Solution>
void take(const Solution& solution, Mode mode, SegmentSolution& result)
{
  result.solved = solution.status == ocp::Status::solved || solution.status == ocp::Status::acceptable;
  result.message = ocp::to_string(solution.status);
  result.points = points_of(solution.trajectory, mode);
  result.iterations += solution.statistics.iterations;
  result.corridor_violation = solution.statistics.elastic_violation;
}

}  // namespace

SegmentOptimizer::SegmentOptimizer(const Robot& robot, const OptimizeOptions& options, double reference_speed)
  : robot_(checked(robot)),
    options_(checked(options)),
    reference_speed_(reference_speed)
{
  require_positive("reference_speed", reference_speed);
}

SegmentSolution SegmentOptimizer::solve(const SegmentTask& task, double tolerance, const Interrupt& interrupt) const
{
  const MotionLimits limits(robot_, task.segment.mode);
  return limits.wheels_limit_speed ? solve_with<WheelSpeedRows>(task, limits, tolerance, interrupt)
                                   : solve_with<NoWheelSpeedRows>(task, limits, tolerance, interrupt);
}

template <class WheelSpeeds>
SegmentSolution SegmentOptimizer::solve_with(const SegmentTask& task, const MotionLimits& limits, double tolerance,
                                             const Interrupt& interrupt) const
{
  const Segment& segment = task.segment;
  const auto problem = segment_problem<WheelSpeeds>(task, robot_, options_, limits, reference_speed_);

  const auto interrupted = [&] { return interrupt.cancelled() || interrupt.timed_out(); };
  ocp::Solver<SegmentModel<WheelSpeeds>> solver;
  SegmentSolution result;
  const auto try_with = [&](const Effort& effort, const ocp::Trajectory<5, 3>& guess) {
    ocp::Options solver_options;
    solver_options.tolerance = tolerance;
    solver_options.max_iterations = effort.iterations;
    solver_options.initial_barrier = effort.barrier;
    take(solver.solve(problem.model, problem.numbers, guess, solver_options, nullptr, interrupted), segment.mode,
         result);
  };
  if (!task.previous)
    try_with(kCold, reference_guess(segment, limits, problem.model.h_ref));
  else
    for (const Effort& effort : kWarm)
    {
      try_with(effort, guess_from(*task.previous));
      if (result.solved || interrupted()) break;
    }
  return result;
}

}  // namespace fourwis
