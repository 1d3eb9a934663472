#include "plan_table.h"

#include "statistics.h"

namespace fourwis::benchmark
{
namespace
{

std::vector<std::string> row(const Problem& problem, const Measurement& measurement)
{
  const PlanMetrics& metrics = measurement.result.metrics;
  const double middle = median(measurement.frontend_ms);
  return {problem.id,
          to_string(measurement.result.status),
          fixed(middle, 2),
          fixed(worst(measurement.frontend_ms), 2),
          fixed(problem.peer_ms, 1),
          fixed(middle / problem.peer_ms, 2),
          std::to_string(metrics.expansions),
          fixed(metrics.length, 2),
          std::to_string(metrics.switches),
          fixed(metrics.arrival_time, 2),
          fixed(median(measurement.verify_ms), 2)};
}

}  // namespace

void report_plans(const Report& report, const Setup& setup, const std::string& title,
                  const std::vector<Problem>& problems)
{
  Table table({"problem", "status", "front end ms", "worst", "peer ms", "ratio", "expansions", "TL m", "switches",
               "AT s", "verify ms"});
  std::vector<double> medians, all;
  std::size_t verified = 0;
  MapCache maps;
  for (const Problem& problem : problems)
  {
    const Measurement measurement = measure(setup, maps.grid(problem.map), problem.start, problem.goal);
    table.add(row(problem, measurement));
    verified += measurement.result.status == PlanStatus::succeeded;
    medians.push_back(median(measurement.frontend_ms));
    all.insert(all.end(), measurement.frontend_ms.begin(), measurement.frontend_ms.end());
  }
  report.title(title);
  report.table(table);
  report.line("verified " + std::to_string(verified) + "/" + std::to_string(problems.size()) + "; front end p50 " +
              fixed(median(medians), 2) + " ms, p95 " + fixed(quantile(medians, 0.95), 2) + " ms, max " +
              fixed(worst(medians), 2) + " ms over the problems' medians of " + std::to_string(setup.runs) +
              " runs; worst run of all " + fixed(worst(all), 2) + " ms");
}

}  // namespace fourwis::benchmark
