#include <boost/program_options.hpp>

#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "can_latency.h"
#include "table.h"

namespace po = boost::program_options;

namespace fourwis::benchmark
{
namespace
{

using Names = std::vector<std::string>;

void report_latencies(const Report& report, const Names& buses, int commands)
{
  report.title("From a callback with a command to its frames in the kernel");
  Table table({"bus", "commands", "p50 us", "p99 us", "worst us", "priority"});
  for (const std::string& bus : buses)
  {
    const CanLatency latency = measure_can_latency(bus, commands);
    const auto microseconds = [](double seconds) { return fixed(1e6 * seconds, 0); };
    table.add({bus, std::to_string(latency.delays.count()), microseconds(latency.delays.percentile(0.5)),
               microseconds(latency.delays.percentile(0.99)), microseconds(latency.delays.longest()),
               latency.real_time ? "real-time" : "normal"});
  }
  report.table(table);
}

int run(int argc, char** argv)
{
  po::options_description options("Measures the bridge's way from a command to the bus. Options");
  auto add = options.add_options();
  add("help,h", "this text");
  add("bus", po::value<Names>()->default_value({"unix:benchmark"}, "unix:benchmark")->composing(),
      "unix:NAME or a SocketCAN interface without drives; may be repeated");
  add("commands", po::value<int>()->default_value(1000), "so many, 50 a second");
  add("markdown", "tables as Markdown");
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(options).positional({}).run(), given);
  po::notify(given);
  if (given.count("help"))
    std::cout << options;
  else
    report_latencies({std::cout, given.count("markdown") > 0}, given["bus"].as<Names>(), given["commands"].as<int>());
  return 0;
}

}  // namespace
}  // namespace fourwis::benchmark

/// Prints a table. Exit status 0, or 2 with a line on the standard error when there is nothing to measure.
int main(int argc, char** argv)
{
  try
  {
    return fourwis::benchmark::run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::cerr << "benchmark_can: " << error.what() << '\n';
    return 2;
  }
}
