#include <boost/program_options.hpp>
#include <exception>
#include <iostream>

#include "setup_arguments.h"
#include "tracking_table.h"

namespace po = boost::program_options;

namespace fourwis::benchmark
{
namespace
{

const std::string kEnvironments = FOURWIS_SOURCE_DIR "/config/environments.csv";

/// A base that answers late, slips and measures badly, and a localiser that is late and noisy.
Circumstances adverse(Circumstances circumstances)
{
  circumstances.simulator.command_latency = circumstances.track.command_latency = 0.06;
  circumstances.simulator.slip.drive_slip = 0.03;
  circumstances.simulator.encoders.angle_noise = 0.002;
  circumstances.simulator.encoders.speed_noise = 0.001;
  circumstances.localisation = {0.02, 0.002, 0.002};
  return circumstances;
}

void run(const Setup& setup, bool markdown)
{
  const Report report{std::cout, markdown};
  const auto environments = plan_environments(setup, read_problems(kEnvironments));
  Circumstances nominal;
  nominal.robot = setup.robot;
  report_tracking(report, nominal, setup.runs, "Tracking on the simulated base", environments, true);
  report_tracking(report, adverse(nominal), setup.runs,
                  "Tracking with 60 ms latency, 3 % slip, encoder and localisation noise", environments, false);
  report_pushes(report, nominal, setup.runs, environments);
}

}  // namespace
}  // namespace fourwis::benchmark

/// Drives the environments' plans on the simulated base, without a ROS master, and prints tables. Exit status 0, or 2 with a
/// line on the standard error for unusable input.
int main(int argc, char** argv)
{
  try
  {
    po::options_description all("Measures how trajectories are tracked; --runs: drives of each environment. Options");
    all.add_options()("help,h", "this text");
    fourwis::benchmark::add_setup_options(all);
    po::variables_map given;
    po::store(po::command_line_parser(argc, argv).options(all).positional({}).run(), given);
    po::notify(given);
    if (given.count("help"))
      std::cout << all;
    else
      fourwis::benchmark::run(fourwis::benchmark::setup_in(given), given.count("markdown") > 0);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_tracking: " << error.what() << '\n';
    return 2;
  }
}
