#include "fourwis_navigation/optimize/paper_optimizer.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/vehicle/mode_traits.h"
#include "ipopt_solver.h"
#include "motion_limits.h"
#include "paper_problem.h"

namespace fourwis
{
namespace
{

/// The paper's limits. It has no limits of single wheels.
MotionLimits paper_limits(const Robot& robot, Mode mode, double reference_speed)
{
  MotionLimits limits(robot, mode);
  limits.speed = std::min(robot.max_speed, reference_speed);
  limits.steering_rate = robot.max_steering_rate;
  return limits;
}

bool fits(const Segment& segment, const BoxCorridor& boxes, const Trajectory* previous)
{
  const std::size_t n = segment.intervals();
  return n > 0 && segment.knots.size() == n + 1 && segment.length.size() == n && boxes.front.size() == n + 1 &&
         boxes.rear.size() == n + 1 && (!previous || previous->size() == n + 1) && traits_of(segment.mode).translates;
}

}  // namespace

void check(const PaperOptions& options)
{
  check_ranges(options);
}

PaperOptimizer::PaperOptimizer(const Robot& robot, const PaperOptions& options, double reference_speed)
  : robot_(checked(robot)),
    options_(checked(options)),
    reference_speed_(reference_speed)
{
  require_positive("reference_speed", reference_speed);
}

PaperSolution PaperOptimizer::solve(const Segment& segment, const BoxCorridor& boxes, const Trajectory* previous,
                                    const Interrupt& interrupt) const
{
  PaperSolution solution;
  if (!fits(segment, boxes, previous)) return solution;

  const MotionLimits limits = paper_limits(robot_, segment.mode, reference_speed_);
  const PaperProblem problem(segment, boxes, robot_, options_, limits, previous);
  IpoptOptions solver_options;
  solver_options.tolerance = options_.tolerance;
  solver_options.max_iterations = options_.max_iterations;
  const NlpResult result = solve_on_ipopt(problem.nlp(), solver_options, interrupt);

  solution.status = result.status;
  solution.iterations = result.iterations;
  if (result.status == NlpStatus::invalid_problem) return solution;
  solution.points = problem.points(result.x);
  solution.infeasibility = paper_infeasibility(solution.points, boxes, robot_);
  return solution;
}

}  // namespace fourwis
