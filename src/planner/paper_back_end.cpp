#include "paper_back_end.h"

#include <algorithm>
#include <utility>

#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/model/sentence.h"
#include "fourwis_navigation/segment/segment.h"

namespace fourwis
{
namespace
{

std::vector<Pose> poses(const Trajectory& points)
{
  std::vector<Pose> result;
  for (const TrajectoryPoint& point : points) result.push_back(point.pose());
  return result;
}

/// Eq. (23): appends a part that begins at t = 0, `pause` after the whole's end.
void append(const Trajectory& part, double pause, Trajectory& whole)
{
  const double begin = whole.empty() ? 0.0 : whole.back().t + pause;
  for (TrajectoryPoint point : part)
  {
    point.t += begin;
    whole.push_back(point);
  }
}

}  // namespace

void check(const PaperBackEndOptions& options)
{
  check_ranges(options);
  check(options.boxes);
}

const char* to_string(PaperStatus status)
{
  switch (status)
  {
    case PaperStatus::converged: return "converged";
    case PaperStatus::not_converged: return "not_converged";
    case PaperStatus::corridor: return "corridor";
    case PaperStatus::interrupted: return "interrupted";
    case PaperStatus::invalid_path: return "invalid_path";
  }
  return "";
}

/// What became of one segment.
struct PaperBackEnd::Outcome
{
  PaperStatus status = PaperStatus::not_converged;
  std::string message;
  PaperSolution solution;
  BoxCorridor corridor;
  int outer_iterations = 0, ipopt_iterations = 0;

  std::string summary() const
  {
    return sentence("psi = %.3g after %d rounds with %d iterations, the last one %s", solution.infeasibility,
                    outer_iterations, ipopt_iterations, to_string(solution.status));
  }
};

PaperBackEnd::PaperBackEnd(const PlanContext& context, const PaperBackEndOptions& options)
  : context_(context),
    options_(options),
    discs_(two_discs(context.robot())),
    optimizer_(context.robot(), options_.program, context.reference_speed())
{
  check(options_);
}

PaperRefinement PaperBackEnd::refine(const Path& path) const
{
  PaperRefinement result;
  const std::vector<Segment> segments = split_at_switches(path, context_.robot(), options_.spacing);
  result.segments = static_cast<int>(segments.size());
  result.message = "the path has nothing to drive, or is unusable";
  for (const Segment& segment : segments)
  {
    Outcome outcome = refine(segment);
    if (&segment == &segments.front() || result.status == PaperStatus::converged)
    {
      result.status = outcome.status;
      result.message = outcome.message;
    }
    append(outcome.solution.points, context_.robot().mode_switch_time, result.trajectory);
    result.outer_iterations = std::max(result.outer_iterations, outcome.outer_iterations);
    result.ipopt_iterations += outcome.ipopt_iterations;
    result.infeasibility = std::max(result.infeasibility, outcome.solution.infeasibility);
    result.corridors.push_back(std::move(outcome.corridor));
    if (context_.interrupt.cancelled() || context_.interrupt.timed_out()) break;
  }
  return result;
}

/// corridor <-> program for one segment.
PaperBackEnd::Outcome PaperBackEnd::refine(const Segment& segment) const
{
  Outcome outcome;
  while (outcome.status == PaperStatus::not_converged && outcome.outer_iterations < options_.outer_iterations)
    iterate(segment, outcome);
  outcome.message = outcome.message.empty() ? outcome.summary() : outcome.message;
  return outcome;
}

void PaperBackEnd::iterate(const Segment& segment, Outcome& outcome) const
{
  const Trajectory& current = outcome.solution.points;
  BoxCorridorResult boxes =
      box_corridor(context_.world.rectangles, discs_, options_.boxes, current.empty() ? segment.knots : poses(current));
  if (boxes.status != CorridorStatus::succeeded)
  {
    outcome.status = PaperStatus::corridor;
    outcome.message = boxes.message;
    return;
  }
  outcome.corridor = std::move(boxes.regions);
  PaperSolution next =
      optimizer_.solve(segment, outcome.corridor, current.empty() ? nullptr : &current, context_.interrupt);
  ++outcome.outer_iterations;
  outcome.ipopt_iterations += next.iterations;
  if (next.status == NlpStatus::invalid_problem)
    outcome.status = PaperStatus::invalid_path;
  else if (next.status == NlpStatus::interrupted)
    outcome.status = PaperStatus::interrupted;
  else if (next.infeasibility < options_.convergence)
    outcome.status = PaperStatus::converged;
  outcome.solution = std::move(next);
}

}  // namespace fourwis
