#include "whole_plan_table.h"

#include <cmath>
#include <numeric>

#include "statistics.h"

namespace fourwis::benchmark
{
namespace
{

double peer_cpu_ms(const Problem& problem)
{
  return problem.peer_ms + problem.peer_backend_ms;
}

bool succeeded(const Measurement& measurement)
{
  return measurement.result.status == PlanStatus::succeeded;
}

std::vector<std::string> time_row(const Problem& problem, const Measurement& measurement)
{
  const double middle = median(measurement.cpu_ms);
  return {problem.id,
          to_string(measurement.result.status),
          fixed(middle, 1),
          fixed(worst(measurement.cpu_ms), 1),
          fixed(peer_cpu_ms(problem), 0),
          fixed(peer_cpu_ms(problem) / middle, 1),
          fixed(median(measurement.map_ms), 2),
          fixed(median(measurement.frontend_ms), 2),
          fixed(median(measurement.backend_ms), 2),
          fixed(median(measurement.verify_ms), 2)};
}

std::vector<std::string> trajectory_row(const Problem& problem, const Measurement& measurement)
{
  const PlanMetrics& metrics = measurement.result.metrics;
  if (!succeeded(measurement))
  {
    std::vector<std::string> cells(15, "-");
    cells.front() = problem.id;
    return cells;
  }
  return {problem.id,
          fixed(metrics.arrival_time, 2),
          fixed(problem.peer_arrival_time, 2),
          fixed(metrics.arrival_time / problem.peer_arrival_time, 3),
          fixed(metrics.length, 2),
          fixed(problem.peer_length, 2),
          fixed(metrics.mean_curvature, 3),
          fixed(metrics.max_curvature, 3),
          fixed(1e3 * metrics.terminal_position_error, 4),
          fixed(1e3 * metrics.terminal_yaw_error, 4),
          fixed(metrics.standard_mode_rate, 3),
          std::to_string(metrics.switches),
          std::to_string(metrics.outer_iterations),
          std::to_string(metrics.ipopt_iterations),
          fixed(1e3 * metrics.min_clearance, 1)};
}

/// What is said of all problems together.
struct Summary
{
  std::size_t verified = 0;
  std::vector<double> cpu_ms;  ///< medians
  std::vector<double> speed_ratios, time_ratios;

  void count(const Problem& problem, const Measurement& measurement)
  {
    cpu_ms.push_back(median(measurement.cpu_ms));
    if (!succeeded(measurement)) return;
    ++verified;
    const double speed_ratio = peer_cpu_ms(problem) / cpu_ms.back();
    const double time_ratio = measurement.result.metrics.arrival_time / problem.peer_arrival_time;
    if (std::isfinite(speed_ratio)) speed_ratios.push_back(speed_ratio);
    if (std::isfinite(time_ratio)) time_ratios.push_back(time_ratio);
  }

  std::string text(int runs) const
  {
    std::string text = "verified " + std::to_string(verified) + "/" + std::to_string(cpu_ms.size()) + "; CPU p50 " +
                       fixed(median(cpu_ms), 1) + " ms, p95 " + fixed(quantile(cpu_ms, 0.95), 1) + " ms, max " +
                       fixed(worst(cpu_ms), 1) + " ms over the problems' medians of " + std::to_string(runs) + " runs";
    if (!speed_ratios.empty())
      text += "; peer CPU / ours p50 " + fixed(median(speed_ratios), 1) + ", least " +
              fixed(quantile(speed_ratios, 0.0), 1);
    if (!time_ratios.empty())
      text +=
          "; AT / peer AT mean " +
          fixed(std::accumulate(time_ratios.begin(), time_ratios.end(), 0.0) / static_cast<double>(time_ratios.size()),
                3) +
          ", worst " + fixed(worst(time_ratios), 3);
    return text;
  }
};

}  // namespace

void report_whole_plans(const Report& report, const Setup& setup, const std::string& title,
                        const std::vector<Problem>& problems)
{
  Table times({"problem", "status", "CPU ms", "worst", "peer CPU ms", "peer / ours", "map ms", "front end ms",
               "back end ms", "verify ms"});
  Table trajectories({"problem", "AT s", "peer AT", "AT / peer", "TL m", "peer TL", "AC 1/m", "MC 1/m", "TPE mm",
                      "TYE mrad", "SMR", "switches", "rounds", "iterations", "clearance mm"});
  Summary summary;
  MapCache maps;
  for (const Problem& problem : problems)
  {
    const Measurement measurement = measure(setup, maps.grid(problem.map), problem.start, problem.goal);
    times.add(time_row(problem, measurement));
    trajectories.add(trajectory_row(problem, measurement));
    summary.count(problem, measurement);
  }
  report.title(title);
  report.table(times);
  report.table(trajectories);
  report.line(summary.text(setup.runs));
}

}  // namespace fourwis::benchmark
