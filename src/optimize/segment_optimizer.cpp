#include "fourwis_navigation/optimize/segment_optimizer.h"

#include "fourwis_navigation/ocp/solver.h"
#include "fourwis_navigation/optimize/motion_limits.h"
#include "segment_problem.h"

namespace fourwis
{
namespace
{

/// Most take 10 to 50 iterations, long lateral segments at full lock now and then 150.
constexpr int kMostIterations = 300;
/// Barrier parameter of a solve that starts from a solution of nearly the same problem.
constexpr double kWarmBarrier = 1e-2;

using Solver = ocp::Solver<SegmentModel>;

}  // namespace

SegmentOptimizer::SegmentOptimizer(const Robot& robot, const OptimizeOptions& options, double reference_speed)
  : robot_(robot), options_(options), reference_speed_(reference_speed)
{
}

SegmentSolution SegmentOptimizer::solve(const Segment& segment, const Corridor& corridor, const Trajectory* previous,
                                        const std::vector<char>& pinned, double tolerance,
                                        const Interrupt& interrupt) const
{
  const MotionLimits limits(robot_, segment.mode, reference_speed_);
  const SegmentProblem problem = segment_problem(segment, corridor, robot_, options_, limits, pinned);

  ocp::Options solver_options;
  solver_options.tolerance = tolerance;
  solver_options.max_iterations = kMostIterations;
  if (previous) solver_options.initial_barrier = kWarmBarrier;
  Solver solver;
  const Solver::Solution& solution =
      solver.solve(problem.model, problem.numbers,
                   previous ? guess_from(*previous) : reference_guess(segment, limits, problem.model.h_ref),
                   solver_options, nullptr, [&] { return interrupt.cancelled() || interrupt.timed_out(); });

  SegmentSolution result;
  result.solved = solution.status == ocp::Status::solved || solution.status == ocp::Status::acceptable;
  result.message = ocp::to_string(solution.status);
  result.points = points_of(solution.trajectory, segment.mode);
  result.iterations = solution.statistics.iterations;
  result.corridor_violation = solution.statistics.elastic_violation;
  return result;
}

}  // namespace fourwis
