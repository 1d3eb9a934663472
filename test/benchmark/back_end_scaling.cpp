#include "back_end_scaling.h"

#include <algorithm>
#include <cmath>

#include "planner/back_end.h"
#include "planner/candidates.h"
#include "statistics.h"

namespace fourwis::benchmark
{
namespace
{

struct Sample
{
  std::string problem;
  double length = 0.0;  ///< of the path [m]
  Refinement refinement;
  std::vector<double> cpu_ms;     ///< of BackEnd::refine()
  std::vector<double> polish_ms;  ///< of BackEnd::polish() in addition

  double refined() const { return median(cpu_ms); }
  double polished() const { return refined() + median(polish_ms); }
};

/// Without runs when there is no path.
Sample refine_first_path(const Setup& setup, const Problem& problem, const OccupancyGrid& grid)
{
  Sample sample;
  sample.problem = problem.id;
  const World world(grid, setup.robot, setup.options);
  const CollisionChecker checker(world.obstacles, world.robot);
  if (!checker.is_free(problem.start) || !checker.is_free(problem.goal)) return sample;
  ThreadBudget threads;
  const Search search({checker, problem.start, problem.goal});
  const Candidates found =
      find_candidates(search, variants_by_time(world.robot, setup.options.search, setup.modes, Effort::both_ways),
                      Effort::thorough, threads);
  if (found.candidates.empty()) return sample;
  sample.length = found.candidates.front().path.length();
  for (int run = 0; run < setup.runs; ++run)
  {
    const double begin = cpu_ms();
    const BackEnd back_end({world, setup.options, checker, {}, threads});
    sample.refinement = back_end.refine(found.candidates.front().path);
    sample.cpu_ms.push_back(cpu_ms() - begin);
    Refinement polished = sample.refinement;
    const double between = cpu_ms();
    back_end.polish(polished);
    sample.polish_ms.push_back(cpu_ms() - between);
  }
  return sample;
}

std::vector<std::string> row(const Sample& sample)
{
  const Refinement& refinement = sample.refinement;
  return {sample.problem,
          fixed(sample.length, 2),
          std::to_string(refinement.trajectory.size()),
          std::to_string(refinement.parts.size()),
          std::to_string(refinement.fallbacks),
          std::to_string(refinement.outer_iterations),
          std::to_string(refinement.solver_iterations),
          fixed(sample.refined(), 2),
          fixed(worst(sample.cpu_ms), 2),
          fixed(sample.refined() / sample.length, 3),
          fixed(sample.polished(), 2),
          fixed(sample.polished() / sample.length, 3)};
}

/// The line y = offset + slope x of least squares, and how well it fits.
struct Line
{
  double offset, slope, correlation;
};

Line fit(const std::vector<double>& x, const std::vector<double>& y)
{
  const double n = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  return {mean_y - xy / xx * mean_x, xy / xx, xy / std::sqrt(xx * yy)};
}

std::string summary(const std::vector<Sample>& samples, double (Sample::*time)() const)
{
  std::vector<double> lengths, times, rates, log_lengths, log_times;
  for (const Sample& sample : samples)
  {
    lengths.push_back(sample.length);
    times.push_back((sample.*time)());
    rates.push_back(times.back() / sample.length);
    log_lengths.push_back(std::log(lengths.back()));
    log_times.push_back(std::log(times.back()));
  }
  const Line line = fit(lengths, times), power = fit(log_lengths, log_times);
  return "CPU ms per metre p50 " + fixed(median(rates), 3) + ", p95 " + fixed(quantile(rates, 0.95), 3) +
         "; least squares: " + fixed(line.offset, 2) + " ms + " + fixed(line.slope, 3) + " ms/m, correlation " +
         fixed(line.correlation, 3) + "; as a power of the length: exponent " + fixed(power.slope, 2) +
         ", correlation " + fixed(power.correlation, 3);
}

}  // namespace

void report_back_end_scaling(const Report& report, const Setup& setup, const std::string& title,
                             const std::vector<Problem>& problems)
{
  std::vector<Sample> samples;
  MapCache maps;
  for (const Problem& problem : problems)
  {
    Sample sample = refine_first_path(setup, problem, maps.grid(problem.map));
    if (!sample.cpu_ms.empty()) samples.push_back(std::move(sample));
  }
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.length < b.length; });
  Table table({"problem", "path m", "points", "segments", "fallbacks", "rounds", "iterations", "CPU ms", "worst",
               "ms per m", "polished ms", "polished ms per m"});
  for (const Sample& sample : samples) table.add(row(sample));
  report.title(title);
  report.table(table);
  report.line("Polished: " + summary(samples, &Sample::polished));
  report.line(summary(samples, &Sample::refined) + "; paths " + std::to_string(samples.size()) + "/" +
              std::to_string(problems.size()));
}

}  // namespace fourwis::benchmark
