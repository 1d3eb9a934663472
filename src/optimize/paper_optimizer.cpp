#include "fourwis_navigation/optimize/paper_optimizer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "fourwis_navigation/vehicle/mode_traits.h"
#include "ipopt_solver.h"
#include "motion_limits.h"
#include "paper_problem.h"

namespace fourwis
{
namespace
{

void check(const char* name, double value, double least, double most)
{
  if (value >= least && value <= most) return;
  throw std::invalid_argument("paper option " + std::string(name) + " = " + std::to_string(value) + ": must lie in [" +
                              std::to_string(least) + ", " + std::to_string(most) + "]");
}

/// The paper's limits: it knows none of single wheels.
MotionLimits paper_limits(const Robot& robot, Mode mode, double reference_speed)
{
  MotionLimits limits(robot, mode, reference_speed);
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

PaperOptimizer::PaperOptimizer(const Robot& robot, const PaperOptions& options, double reference_speed)
  : robot_(robot),
    options_(options),
    reference_speed_(reference_speed)
{
  check("steering_comfort", options.steering_comfort, 0.0, 1e6);
  check("penalty", options.penalty, 1.0, 1e12);
  check("tolerance", options.tolerance, 1e-12, 1.0);
  check("max_iterations", options.max_iterations, 0.0, 1e6);
  check("reference_speed", reference_speed, 1e-6, 1e6);
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
