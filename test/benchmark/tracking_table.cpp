#include "tracking_table.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "../support/random.h"
#include "statistics.h"
#include "trajectory_at.h"

namespace fourwis::benchmark
{
namespace
{

double mean(const std::vector<double>& sample)
{
  return sample.empty() ? kUnknown : std::accumulate(sample.begin(), sample.end(), 0.0) / double(sample.size());
}

/// Several drives along one trajectory.
struct Drives
{
  int count = 0, arrived = 0, stopped = 0, collided = 0;
  std::vector<double> lateral, longitudinal, terminal_position, terminal_heading, step_ms, driving, aligning;
  std::string message;  ///< of the first that did not arrive

  void add(const DriveResult& drive)
  {
    ++count;
    arrived += drive.state == TrackState::arrived;
    stopped += drive.state == TrackState::failed;
    collided += drive.collided;
    if (message.empty() && drive.state != TrackState::arrived) message = drive.message;
    lateral.insert(lateral.end(), drive.lateral.begin(), drive.lateral.end());
    longitudinal.insert(longitudinal.end(), drive.longitudinal.begin(), drive.longitudinal.end());
    step_ms.insert(step_ms.end(), drive.step_ms.begin(), drive.step_ms.end());
    terminal_position.push_back(drive.terminal_position);
    terminal_heading.push_back(drive.terminal_heading);
    driving.push_back(drive.driving);
    aligning.push_back(drive.aligning);
  }
};

void drive_all(const DriveConditions& conditions, const PlannedEnvironment& environment, int seeds, Drives& drives)
{
  for (int seed = 1; seed <= seeds; ++seed)
    drives.add(simulate(conditions, environment.trajectory, &environment.grid, seed));
}

std::string of(int part, int whole)
{
  return std::to_string(part) + "/" + std::to_string(whole);
}

std::vector<std::string> row(const PlannedEnvironment& environment, const Drives& drives)
{
  const double planned = driving_time(environment.trajectory), driven = mean(drives.driving);
  return {environment.id,
          of(drives.arrived, drives.count),
          std::to_string(drives.collided),
          fixed(1e3 * mean(drives.lateral), 2),
          fixed(1e3 * worst(drives.lateral), 1),
          fixed(1e3 * mean(drives.longitudinal), 2),
          fixed(1e3 * worst(drives.longitudinal), 1),
          fixed(1e3 * worst(drives.terminal_position), 1),
          fixed(180.0 / M_PI * worst(drives.terminal_heading), 2),
          fixed(median(drives.step_ms), 3),
          fixed(quantile(drives.step_ms, 0.99), 3),
          fixed(environment.trajectory.back().t, 2),
          fixed(planned, 2),
          fixed(driven, 2),
          fixed(100.0 * (driven / planned - 1.0), 1),
          fixed(mean(drives.aligning), 2)};
}

const std::vector<std::string> kHeader = {
    "environment", "arrived", "collided", "lateral mm", "max",           "longitudinal mm", "max",    "at goal mm",
    "deg",         "step ms", "p99",      "AT s",       "of it driving", "driven s",        "more %", "aligning s"};

std::vector<std::string> paper_row()
{
  std::vector<std::string> cells(kHeader.size(), "-");
  cells[0] = "paper's robot";
  cells[3] = "9.6";
  cells[4] = "38.8";
  cells[5] = "8.6";
  cells[6] = "29.3";
  return cells;
}

/// A shove of 0.1 m to one side or along, or of 10 degrees, at some moment.
Push random_push(Random& random, const Trajectory& trajectory)
{
  const double at = random.between(0.0, trajectory.back().t), side = random.chance(0.5) ? 1.0 : -1.0;
  switch (random.whole(0, 2))
  {
    case 0: return {at, {0.0, 0.1 * side, 0.0}};
    case 1: return {at, {0.1 * side, 0.0, 0.0}};
    default: return {at, {0.0, 0.0, side * M_PI / 18.0}};
  }
}

}  // namespace

std::vector<PlannedEnvironment> plan_environments(const Setup& setup, const std::vector<Problem>& problems)
{
  std::vector<PlannedEnvironment> environments;
  MapCache maps;
  const Planner planner(setup.options);
  for (const Problem& problem : problems)
  {
    const OccupancyGrid& grid = maps.grid(problem.map);
    const PlanResult result =
        planner.plan(World(grid, setup.robot, setup.options), {problem.start, problem.goal, setup.modes, false});
    if (result.status != PlanStatus::succeeded) throw std::runtime_error(problem.id + ": " + result.message);
    environments.push_back({problem.id, grid, result.trajectory});
  }
  return environments;
}

void report_tracking(const Report& report, const DriveConditions& conditions, int seeds, const std::string& title,
                     const std::vector<PlannedEnvironment>& environments)
{
  Table table(kHeader);
  std::string messages;
  for (const PlannedEnvironment& environment : environments)
  {
    Drives drives;
    drive_all(conditions, environment, seeds, drives);
    table.add(row(environment, drives));
    if (!drives.message.empty()) messages += " " + environment.id + ": " + drives.message + ".";
  }
  table.add(paper_row());
  report.title(title);
  report.table(table);
  if (!messages.empty()) report.line("Not arrived, for example:" + messages);
}

void report_variations(const Report& report, const std::vector<Variation>& variations, int seeds,
                       const std::vector<PlannedEnvironment>& environments)
{
  Table table(
      {"what differs", "arrived", "collided", "lateral mm", "max", "longitudinal mm", "max", "at goal mm", "deg"});
  for (const Variation& variation : variations)
  {
    Drives drives;
    for (const PlannedEnvironment& environment : environments)
      drive_all(variation.conditions, environment, seeds, drives);
    table.add({variation.name, of(drives.arrived, drives.count), std::to_string(drives.collided),
               fixed(1e3 * mean(drives.lateral), 2), fixed(1e3 * worst(drives.lateral), 1),
               fixed(1e3 * mean(drives.longitudinal), 2), fixed(1e3 * worst(drives.longitudinal), 1),
               fixed(1e3 * worst(drives.terminal_position), 1),
               fixed(180.0 / M_PI * worst(drives.terminal_heading), 2)});
    if (!drives.message.empty()) report.line(variation.name + ": " + drives.message);
  }
  report.title("Tracking where something differs, all environments");
  report.table(table);
}

void report_pushes(const Report& report, const DriveConditions& conditions, int seeds,
                   const std::vector<PlannedEnvironment>& environments)
{
  Table table({"environment", "pushes", "returned and arrived", "stopped and said so", "collided", "lateral max mm",
               "at goal mm", "deg"});
  for (const PlannedEnvironment& environment : environments)
  {
    Drives drives;
    Random random(1);
    for (int seed = 1; seed <= seeds; ++seed)
    {
      DriveConditions pushed = conditions;
      pushed.push = random_push(random, environment.trajectory);
      drives.add(simulate(pushed, environment.trajectory, &environment.grid, seed));
    }
    table.add({environment.id, std::to_string(drives.count), std::to_string(drives.arrived),
               std::to_string(drives.stopped), std::to_string(drives.collided), fixed(1e3 * worst(drives.lateral), 1),
               fixed(1e3 * median(drives.terminal_position), 1),
               fixed(180.0 / M_PI * median(drives.terminal_heading), 2)});
    if (!drives.message.empty()) report.line(environment.id + ": " + drives.message);
  }
  report.title("Pushed off the trajectory by 0.1 m or 10 degrees");
  report.table(table);
}

}  // namespace fourwis::benchmark
