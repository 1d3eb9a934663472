// The rows of issue 10's table "Figures": what was asked beside what is measured. Exit status 1 when an answer is wrong or the
// program was stopped, 2 for arguments that make no sense.

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include <boost/program_options.hpp>

#include "figures.h"

namespace po = boost::program_options;

namespace fourwis::nightly
{
namespace
{

struct Part
{
  const char* name;
  void (*measure)(const Figures&);
};

constexpr Part kParts[] = {{"floods", floods_against_the_exact_body},
                           {"failing", failing_cases},
                           {"pairs", random_pairs_of_the_default_robot},
                           {"robots", random_robots},
                           {"car", parking_of_a_car},
                           {"streets", street_maps}};

po::options_description options()
{
  po::options_description all(
      "nightly_figures [OPTION]... [PART]...\nParts: floods failing pairs robots car streets\nOptions");
  auto add = all.add_options();
  add("help,h", "this text");
  add("share", po::value<double>()->default_value(1.0), "of everything, 0.1 is a tenth");
  add("beside", po::value<std::string>()->default_value(""), "folder with third-party maps/ and problems/");
  add("cases", po::value<std::string>()->default_value(""), "folder to write what went wrong to");
  add("part", po::value<std::vector<std::string>>()->composing(), "these instead of all");
  return all;
}

int run(int argc, char** argv)
{
  const po::options_description all = options();
  po::positional_options_description parts;
  parts.add("part", -1);
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(all).positional(parts).run(), given);
  if (given.count("help") > 0)
  {
    std::cout << all;
    return 0;
  }
  std::vector<std::string> wanted;
  if (given.count("part") > 0) wanted = given["part"].as<std::vector<std::string>>();
  for (const std::string& name : wanted)
    if (std::none_of(std::begin(kParts), std::end(kParts), [&](const Part& part) { return part.name == name; }))
      throw po::error("there is no part " + name);
  watch_signals();
  Rows rows;
  CaseBook cases(given["cases"].as<std::string>());
  const double share = given["share"].as<double>();
  if (!(share > 0.0 && share <= 1.0)) throw po::error("--share must be in (0, 1]");
  const Figures figures{share, given["beside"].as<std::string>(), rows, cases};
  for (const Part& part : kParts)
    if (!Figures::stopped() && (wanted.empty() || std::find(wanted.begin(), wanted.end(), part.name) != wanted.end()))
    {
      std::cout << "=== " << part.name << std::endl;
      part.measure(figures);
      rows.print();  // after each part, as a run may be stopped
    }
  if (Figures::stopped()) std::cout << "stopped: there is more to measure\n";
  return rows.all_right() && !Figures::stopped() ? 0 : 1;
}

}  // namespace
}  // namespace fourwis::nightly

int main(int argc, char** argv)
{
  try
  {
    return fourwis::nightly::run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::cerr << "nightly_figures: " << error.what() << '\n';
    return 2;
  }
}
