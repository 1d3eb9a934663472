#include <algorithm>
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
DriveConditions adverse(DriveConditions conditions)
{
  conditions.simulator.command_latency = conditions.track.command_latency = 0.06;
  conditions.simulator.slip.drive_slip = 0.03;
  conditions.simulator.encoders.angle_noise = 0.002;
  conditions.simulator.encoders.speed_noise = 0.001;
  conditions.localisation = {0.02, 0.002, 0.002};
  return conditions;
}

/// One thing at a time that the tracker does not know of, or that it is asked for.
std::vector<Variation> variations(const DriveConditions& usual)
{
  std::vector<Variation> all;
  const auto vary = [&](const std::string& name) -> DriveConditions& {
    return all.emplace_back(Variation{name, usual}).conditions;
  };
  vary("20 Hz").track.controller_frequency = 20.0;
  vary("60 ms latency, 20 ms expected").simulator.command_latency = 0.06;
  vary("lags twice as long as expected").simulator.actuators = {0.04, 0.06, 12.0};
  vary("3 % slip").simulator.slip.drive_slip = 0.03;
  vary("slip angle 0.01 rad at 1 m/s^2").simulator.slip.lateral_slip = 0.01;
  vary("localisation noise 5 mm, 0.3 deg").localisation = {0.0, 0.005, 0.005};
  vary("pose 60 ms old").localisation.delay = 0.06;
  return all;
}

void run(const Setup& setup, bool markdown)
{
  const Report report{std::cout, markdown};
  const auto environments = plan_environments(setup, read_problems(kEnvironments));
  DriveConditions nominal;
  nominal.robot = setup.robot;
  report_tracking(report, nominal, setup.runs, "Tracking on the simulated base", environments);
  report_tracking(report, adverse(nominal), setup.runs,
                  "Tracking with 60 ms latency, 3 % slip, encoder and localisation noise", environments);
  report_variations(report, variations(nominal), std::max(1, setup.runs / 5), environments);
  report_pushes(report, nominal, setup.runs, environments);
}

}  // namespace
}  // namespace fourwis::benchmark

/// Drives the environments' plans on the simulated base, without a ROS master, and prints tables. Exit status 0, or 2
/// with a line on the standard error for unusable input.
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
