#include "backend_arguments.h"

#include <stdexcept>

#include "setup_arguments.h"

namespace po = boost::program_options;

namespace fourwis::benchmark
{
namespace
{

using Files = std::vector<std::string>;

po::options_description options()
{
  po::options_description all("Measures the whole pipeline and the back end. Options");
  auto add = all.add_options();
  add("help,h", "this text");
  add("problems", po::value<Files>()->composing(), "plan each line id;map;start;goal of a file; may be repeated");
  add("backend-only", "only refine the first path of each of those problems, all files in one table");
  add("environments",
      "the project's own environments, all modes and Ackermann only, at several speeds beside the paper's table");
  add("paper", "the paper's back end on the environments in Ackermann motion beside the default one");
  add_setup_options(all);
  return all;
}

void check(const BackendArguments& arguments)
{
  if (arguments.backend_only && arguments.problems.empty())
    throw std::runtime_error("--backend-only: needs --problems");
  if (arguments.problems.empty() && !arguments.environments && !arguments.paper)
    throw std::runtime_error("nothing to measure; see --help");
}

}  // namespace

BackendArguments parse_backend_arguments(int argc, const char* const* argv)
{
  const po::options_description all = options();
  const po::variables_map given = options_given(argc, argv, all);
  BackendArguments arguments;
  if (given.count("help"))
  {
    arguments.help = help_text(all);
    return arguments;
  }
  arguments.problems = files_in(given, "problems");
  arguments.backend_only = given.count("backend-only") > 0;
  arguments.environments = given.count("environments") > 0;
  arguments.paper = given.count("paper") > 0;
  arguments.markdown = given.count("markdown") > 0;
  arguments.setup = setup_in(given);
  arguments.setup.frontend_only = false;
  check(arguments);
  return arguments;
}

}  // namespace fourwis::benchmark
