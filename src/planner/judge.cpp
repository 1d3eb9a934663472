#include "judge.h"

#include <utility>

#include "fourwis_navigation/referee/metrics.h"
#include "plan_sentences.h"

namespace fourwis
{

std::size_t judge(const World& world, const PlanRequest& request, std::vector<Trajectory> trajectories,
                  PlanResult& result)
{
  const PlanClock::time_point begin = PlanClock::now();
  std::size_t chosen = 0;
  Verdict verdict;
  for (chosen = 0; chosen < trajectories.size(); ++chosen)
  {
    verdict = world.referee.judge(request.start, request.goal, trajectories[chosen]);
    if (verdict.accepted() || chosen + 1 == trajectories.size()) break;
  }
  result.trajectory = std::move(trajectories[chosen]);

  PlanMetrics& metrics = result.metrics;
  metrics.verify_ms = ms_since(begin);
  metrics.safe = verdict.accepted();
  metrics.min_clearance = verdict.min_clearance;
  metrics.terminal_position_error = verdict.terminal_position_error;
  metrics.terminal_yaw_error = verdict.terminal_yaw_error;
  measure(result.trajectory, world.robot, metrics);
  result.status = verdict.accepted() ? PlanStatus::succeeded : PlanStatus::verification_failed;
  result.message = verdict.accepted()
                       ? sentence("%.2f m in %.2f s with %d mode switch%s", metrics.length, metrics.arrival_time,
                                  metrics.switches, metrics.switches == 1 ? "" : "es")
                       : verdict.violations.front().what;
  if (!verdict.accepted()) result.trajectory.clear();
  return chosen;
}

}  // namespace fourwis
