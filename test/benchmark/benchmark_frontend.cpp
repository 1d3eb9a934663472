#include <exception>
#include <iostream>
#include <stdexcept>

#include "ablation.h"
#include "barn.h"
#include "corner_to_corner.h"
#include "frontend_arguments.h"
#include "plan_table.h"
#include "walled_in.h"

namespace fourwis::benchmark
{
namespace
{

const std::string kEnvironments = FOURWIS_SOURCE_DIR "/config/environments.csv";

void report_problems(const Report& report, const Arguments& arguments, const std::string& file)
{
  const std::string name = file.substr(file.find_last_of('/') + 1);
  const std::vector<Problem> problems = read_problems(file);
  if (arguments.walled_in)
    report_walled_in(report, arguments.setup, "Goals walled in: " + name, problems);
  else
    report_plans(report, arguments.setup, "Problems of " + name, problems);
}

Problem environment(const std::string& id)
{
  for (const Problem& problem : read_problems(kEnvironments))
    if (problem.id == id) return problem;
  throw std::runtime_error(kEnvironments + ": expected a line " + id);
}

void run(const Arguments& arguments)
{
  const Report report{std::cout, arguments.markdown};
  for (const std::string& file : arguments.problems) report_problems(report, arguments, file);
  if (arguments.environments) report_problems(report, arguments, kEnvironments);
  if (arguments.ablation) report_ablation(report, arguments.setup, environment("env4"));
  if (!arguments.barn.empty()) report_barn(report, arguments.setup, arguments.barn, arguments.export_folder);
  if (arguments.corner_to_corner) report_corner_to_corner(report, arguments.setup, arguments.maps);
}

}  // namespace
}  // namespace fourwis::benchmark

/// Prints tables. Exit status 0, or 2 with a line on the standard error for unusable input.
int main(int argc, char** argv)
{
  try
  {
    const fourwis::benchmark::Arguments arguments = fourwis::benchmark::parse_arguments(argc, argv);
    if (arguments.help.empty())
      fourwis::benchmark::run(arguments);
    else
      std::cout << arguments.help;
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_frontend: " << error.what() << '\n';
    return 2;
  }
}
