#include "plan_command.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "arguments.h"
#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/parameters/parameters.h"
#include "fourwis_navigation/planner/planner.h"
#include "fourwis_navigation/vehicle/mode_limits.h"
#include "output_file.h"
#include "picture.h"
#include "report.h"

namespace fourwis
{
namespace
{

enum ExitStatus
{
  kPlanned = 0,
  kNoPlan = 1,
  kUnusableInput = 2
};

/// The question, read from the files that the arguments name.
struct Problem
{
  OccupancyGrid grid;
  Robot robot;
  PlannerOptions options;
  PlanRequest request;
  std::vector<std::string> notes;  ///< what a person should know of the files
};

/// The answer; the trace is empty unless asked for.
struct Answer
{
  PlanResult result;
  PlanTrace trace;
};

Problem read_problem(const PlanArguments& arguments)
{
  Problem problem;
  std::string robot_defaults, planner_defaults, map_warning;
  if (!arguments.robot.empty()) problem.robot = read_robot_file(arguments.robot, &robot_defaults);
  if (!arguments.planner.empty()) problem.options = read_planner_file(arguments.planner, &planner_defaults);
  problem.grid = arguments.octomap.empty() ? read_map_file(arguments.map, &map_warning)
                                           : project_octomap_file(arguments.octomap, arguments.band);
  problem.request = {arguments.start, arguments.goal, arguments.modes, arguments.frontend_only};
  if (!map_warning.empty()) problem.notes.push_back("warning: " + map_warning);
  for (const std::string& note : {robot_defaults, planner_defaults})
    if (!note.empty()) problem.notes.push_back(note);
  return problem;
}

/// The files asked for; null where there is none. Opened before planning, so that an unusable name costs no time.
struct Outputs
{
  Outputs(const PlanArguments& arguments, std::ostream& standard_output)
    : csv(open(arguments.csv, nullptr)),
      svg(open(arguments.svg, nullptr)),
      json(open(arguments.json, &standard_output)),
      corridors(arguments.corridors),
      iterations(arguments.iterations)
  {}

  static std::unique_ptr<OutputFile> open(const std::string& path, std::ostream* standard_output)
  {
    return path.empty() ? nullptr : std::make_unique<OutputFile>(path, standard_output);
  }

  std::unique_ptr<OutputFile> csv, svg, json;
  bool corridors, iterations;  ///< whether the picture shows them
};

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

/// Plans `repeat` times from grid to verdict; the times of the answer are medians.
Answer plan_repeatedly(const Problem& problem, int repeat, bool traced)
{
  const Planner planner(problem.options);
  Answer answer;
  PlanResult& result = answer.result;
  std::vector<PlanMetrics> runs;
  for (int i = 0; i < repeat; ++i)
  {
    const World world(problem.grid, problem.robot, problem.options);
    answer.trace = {};
    result = planner.plan(world, problem.request, {}, traced ? &answer.trace : nullptr);
    runs.push_back(result.metrics);
  }
  for (double PlanMetrics::*time : {&PlanMetrics::total_ms, &PlanMetrics::map_ms, &PlanMetrics::frontend_ms,
                                    &PlanMetrics::backend_ms, &PlanMetrics::verify_ms})
  {
    std::vector<double> times;
    times.reserve(runs.size());
    for (const PlanMetrics& run : runs) times.push_back(run.*time);
    result.metrics.*time = median(times);
  }
  return answer;
}

std::vector<Corridor> corridors(const Outputs& outputs, const PlanTrace& trace)
{
  if (!outputs.corridors) return {};
  return outputs.iterations ? trace.all_corridors() : trace.corridors();
}

std::vector<Trajectory> iterations(const Outputs& outputs, const PlanTrace& trace)
{
  return outputs.iterations ? trace.iterations() : std::vector<Trajectory>();
}

void write(const Outputs& outputs, const Problem& problem, const Answer& answer)
{
  const PlanRequest& request = problem.request;
  const PlanResult& result = answer.result;
  if (outputs.csv) write_csv(outputs.csv->stream(), result.trajectory);
  if (outputs.svg)
    write_svg(outputs.svg->stream(),
              {problem.grid, problem.options.obstacles, problem.robot, request.start, request.goal, result,
               corridors(outputs, answer.trace), iterations(outputs, answer.trace)});
  if (outputs.csv) outputs.csv->commit();
  if (outputs.svg) outputs.svg->commit();

  // Last, because an answer on the standard output cannot be taken back.
  if (!outputs.json) return;
  write_json(outputs.json->stream(), result);
  outputs.json->commit();
}

/// One line for a person, also where `text` has several.
void tell(std::ostream& err, std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  err << "plan: " << text << std::endl;
}

std::string summary(const PlanResult& result)
{
  return std::string(to_string(result.status)) + (result.message.empty() ? "" : ": " + result.message);
}

/// Reports unusable input on `err` and, where that can be written, as JSON.
int report_unusable(const std::string& why, const std::string& json_file, std::ostream& out, std::ostream& err)
{
  tell(err, why);
  if (json_file.empty()) return kUnusableInput;
  try
  {
    OutputFile json(json_file, &out);
    write_json(json.stream(), no_plan(PlanStatus::invalid_input, why));
    json.commit();
  }
  catch (const OutputError&)
  {
    // `err` has the reason already.
  }
  return kUnusableInput;
}

int run(const PlanArguments& arguments, std::ostream& out, std::ostream& err)
{
  const Problem problem = read_problem(arguments);
  for (const std::string& limitation : limitations(problem.robot)) tell(err, limitation);
  const Outputs outputs(arguments, out);
  const Answer answer = plan_repeatedly(problem, arguments.repeat, arguments.corridors || arguments.iterations);
  const PlanResult& result = answer.result;
  write(outputs, problem, answer);
  for (const std::string& note : problem.notes) tell(err, note);
  tell(err, summary(result));
  if (result.status == PlanStatus::succeeded) return kPlanned;
  return result.status == PlanStatus::invalid_input ? kUnusableInput : kNoPlan;
}

}  // namespace

int plan_command(int argc, const char* const* argv, std::ostream& out, std::ostream& err)
{
  std::string json_file;
  try
  {
    const PlanArguments arguments = parse_arguments(argc, argv);
    json_file = arguments.json;
    if (arguments.text.empty()) return run(arguments, out, err);
    out << arguments.text;
    return kPlanned;
  }
  catch (const UsageError& error)
  {
    return report_unusable(error.what(), error.json, out, err);
  }
  catch (const std::exception& error)
  {
    return report_unusable(error.what(), json_file, out, err);
  }
}

}  // namespace fourwis
