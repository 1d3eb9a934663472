#include "environment_table.h"

#include "paper_results.h"
#include "statistics.h"

namespace fourwis::benchmark
{
namespace
{

constexpr double kPaperSpeed = 1.0;  ///< v_ref of the paper's Table I [m/s]

std::vector<std::string> our_cells(const Measurement& measurement)
{
  const PlanMetrics& metrics = measurement.result.metrics;
  std::vector<std::string> cells(9, "-");
  if (measurement.result.status == PlanStatus::succeeded)
    cells = {fixed(metrics.length, 3),
             fixed(metrics.arrival_time, 3),
             fixed(metrics.mean_curvature, 3),
             fixed(metrics.max_curvature, 3),
             fixed(metrics.standard_mode_rate, 3),
             std::to_string(metrics.switches),
             fixed(1e3 * metrics.min_clearance, 1),
             fixed(median(measurement.cpu_ms), 1),
             fixed(worst(measurement.cpu_ms), 1)};
  cells.insert(cells.begin(), to_string(measurement.result.status));
  return cells;
}

std::vector<std::string> paper_cells(const PaperResult& paper)
{
  return {fixed(paper.length, 3),        fixed(paper.arrival_time, 3),       fixed(paper.mean_curvature, 3),
          fixed(paper.max_curvature, 3), fixed(paper.standard_mode_rate, 3), fixed(paper.ms, 1)};
}

std::vector<std::string> row(Setup setup, const Problem& environment, const OccupancyGrid& grid, bool all_modes)
{
  setup.modes = all_modes ? ModeSet() : ModeSet{Mode::ackermann};
  const Measurement measurement = measure(setup, grid, environment.start, environment.goal);
  std::vector<std::string> cells = {environment.id, all_modes ? "Multi-SC" : "Single-SC"};
  const std::vector<std::string> ours = our_cells(measurement);
  cells.insert(cells.end(), ours.begin(), ours.end());
  if (setup.options.search.v_ref(setup.robot) == kPaperSpeed)
  {
    const std::vector<std::string> theirs = paper_cells(paper_result(environment.id, all_modes));
    cells.insert(cells.end(), theirs.begin(), theirs.end());
  }
  return cells;
}

}  // namespace

void report_environments(const Report& report, const Setup& setup, const std::vector<Problem>& environments)
{
  for (const double speed : {kPaperSpeed, 1.5, 2.0})
  {
    std::vector<std::string> header = {"environment", "modes", "status",   "TL m",         "AT s",   "AC 1/m",
                                       "MC 1/m",      "SMR",   "switches", "clearance mm", "CPU ms", "worst"};
    if (speed == kPaperSpeed)
      header.insert(header.end(), {"paper TL", "paper AT", "paper AC", "paper MC", "paper SMR", "paper CT ms"});
    Table table(header);
    Setup at_speed = setup;
    at_speed.options.search.reference_speed = at_speed.robot.max_speed = speed;
    MapCache maps;
    for (const Problem& environment : environments)
      for (const bool all_modes : {false, true})
        table.add(row(at_speed, environment, maps.grid(environment.map), all_modes));
    report.title("Environments at v_ref = v_max = " + fixed(speed, 1) + " m/s");
    report.table(table);
  }
  report.line("CPU ms are medians of " + std::to_string(setup.runs) +
              " runs. The paper's maps are other ones of the same description, and its CT is another machine's.");
}

}  // namespace fourwis::benchmark
