#include <exception>
#include <iostream>

#include "back_end_scaling.h"
#include "backend_arguments.h"
#include "environment_table.h"
#include "paper_comparison.h"
#include "whole_plan_table.h"

namespace fourwis::benchmark
{
namespace
{

const std::string kEnvironments = FOURWIS_SOURCE_DIR "/config/environments.csv";

std::string names_of(const ModeSet& modes)
{
  std::string names;
  for (const Mode mode : kPlannedModes)
    if (modes.contains(mode)) names += (names.empty() ? "" : ", ") + std::string(to_string(mode));
  return names;
}

void report_problems(const Report& report, const BackendArguments& arguments)
{
  for (const std::string& file : arguments.problems)
    report_whole_plans(
        report, arguments.setup,
        "Whole plans: " + file.substr(file.find_last_of('/') + 1) + " (" + names_of(arguments.setup.modes) + ")",
        read_problems(file));
}

void report_scaling(const Report& report, const BackendArguments& arguments)
{
  std::vector<Problem> all;
  for (const std::string& file : arguments.problems)
  {
    const std::vector<Problem> problems = read_problems(file);
    all.insert(all.end(), problems.begin(), problems.end());
  }
  report_back_end_scaling(report, arguments.setup, "The back end's time over the length of the path", all);
}

void run(const BackendArguments& arguments)
{
  const Report report{std::cout, arguments.markdown};
  if (arguments.backend_only)
    report_scaling(report, arguments);
  else
    report_problems(report, arguments);
  if (arguments.environments) report_environments(report, arguments.setup, read_problems(kEnvironments));
  if (arguments.paper) report_paper_comparison(report, arguments.setup, read_problems(kEnvironments));
}

}  // namespace
}  // namespace fourwis::benchmark

/// Prints tables. Exit status 0, or 2 with a line on the standard error for unusable input.
int main(int argc, char** argv)
{
  try
  {
    const fourwis::benchmark::BackendArguments arguments = fourwis::benchmark::parse_backend_arguments(argc, argv);
    if (arguments.help.empty())
      fourwis::benchmark::run(arguments);
    else
      std::cout << arguments.help;
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_backend: " << error.what() << '\n';
    return 2;
  }
}
