#include "paper_comparison.h"

#include <cstdio>

#include "fourwis_navigation/search/search.h"
#include "paper_results.h"
#include "planner/back_end.h"
#include "planner/paper_back_end.h"
#include "statistics.h"

namespace fourwis::benchmark
{
namespace
{

/// Runs `work` setup.runs times; the CPU time of each [ms].
template <typename Work>
std::vector<double> cpu_times(const Setup& setup, const Work& work)
{
  std::vector<double> times;
  for (int run = 0; run < setup.runs; ++run)
  {
    const double begin = cpu_ms();
    work();
    times.push_back(cpu_ms() - begin);
  }
  return times;
}

std::string scientific(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", value);
  return text;
}

double duration(const Trajectory& trajectory)
{
  return trajectory.empty() ? kUnknown : trajectory.back().t;
}

std::string verb_of(const Verdict& verdict)
{
  return verdict.accepted() ? "accepts" : "refuses";
}

/// Both back ends on one path.
class Comparison
{
public:
  Comparison(const Setup& setup, const Problem& environment, const OccupancyGrid& grid)
    : setup_(setup),
      environment_(environment),
      world_(grid, setup.robot, setup.options),
      checker_(world_.obstacles, world_.robot),
      found_(Search({checker_, environment.start, environment.goal}).find(setup.options.search, setup.modes))
  {
    if (found_.status != PlanStatus::succeeded) return;
    ThreadBudget threads;
    const PlanContext context{world_, setup.options, checker_, {}, threads};
    paper_ms_ = cpu_times(setup, [&] { paper_ = PaperBackEnd(context).refine(found_.path); });
    ours_ms_ = cpu_times(setup, [&] { ours_ = BackEnd(context).refine(found_.path); });
    whole_ = measure(setup, grid, environment.start, environment.goal);
  }

  std::vector<std::string> row() const
  {
    const PaperResult& published = paper_result(environment_.id, false);
    std::vector<std::string> cells(13, "-");
    if (found_.status == PlanStatus::succeeded)
      cells = {fixed(found_.path.length(), 2),
               to_string(paper_.status),
               std::to_string(paper_.outer_iterations),
               std::to_string(paper_.ipopt_iterations),
               scientific(paper_.infeasibility),
               fixed(duration(paper_.trajectory), 3),
               fixed(median(paper_ms_), 1),
               verb_of(judge(paper_.trajectory)),
               fixed(duration(ours_.trajectory), 3),
               fixed(median(ours_ms_), 1),
               verb_of(judge(ours_.trajectory)),
               fixed(whole_.result.metrics.arrival_time, 3),
               fixed(median(whole_.cpu_ms), 1)};
    cells.insert(cells.begin(), environment_.id);
    cells.insert(cells.end(), {fixed(published.arrival_time, 3), fixed(published.ms, 1)});
    return cells;
  }

  /// Why the referee refuses the trajectory of the paper's back end; empty if it does not.
  std::string violation_found() const
  {
    if (found_.status != PlanStatus::succeeded) return "";
    const Verdict verdict = judge(paper_.trajectory);
    if (verdict.accepted()) return "";
    return environment_.id + ": " + verdict.violations.front().what + " (at " + fixed(verdict.violations.front().t, 2) +
           " s; least clearance " + fixed(1e3 * verdict.min_clearance, 1) + " mm, worst rollout miss " +
           fixed(1e3 * verdict.max_rollout_position, 1) + " mm)";
  }

private:
  Verdict judge(const Trajectory& trajectory) const
  {
    return world_.referee.judge(environment_.start, environment_.goal, trajectory);
  }

  const Setup& setup_;
  const Problem& environment_;
  const World world_;
  const CollisionChecker checker_;
  const SearchResult found_;
  PaperRefinement paper_;
  Refinement ours_;
  std::vector<double> paper_ms_, ours_ms_;
  Measurement whole_;  ///< the planner from the grid, which chooses among several paths
};

}  // namespace

void report_paper_comparison(const Report& report, const Setup& setup, const std::vector<Problem>& environments)
{
  Table table({"environment", "path m", "status", "rounds", "Ipopt iterations", "psi", "T s", "CPU ms", "referee",
               "default T s", "default CPU ms", "default referee", "planner AT s", "planner CPU ms", "paper AT",
               "paper CT ms"});
  Setup ackermann = setup;
  ackermann.modes = {Mode::ackermann};
  std::vector<std::string> violations_found;
  MapCache maps;
  for (const Problem& environment : environments)
  {
    const Comparison comparison(ackermann, environment, maps.grid(environment.map));
    table.add(comparison.row());
    if (!comparison.violation_found().empty()) violations_found.push_back(comparison.violation_found());
  }
  report.title("The paper's back end and the default one, in Ackermann motion");
  report.table(table);
  for (const std::string& violation_found : violations_found)
    report.line("The referee on the paper's back end, " + violation_found);
}

}  // namespace fourwis::benchmark
