#pragma once

#include <boost/program_options.hpp>
#include <string>
#include <vector>

#include "measurement.h"

namespace fourwis::benchmark
{

/// Adds what all programs that measure have in common: runs, modes, robot, planner, markdown.
void add_setup_options(boost::program_options::options_description& options);

/// What the command line gives of the options; a word that belongs to none is an error.
boost::program_options::variables_map options_given(int argc, const char* const* argv,
                                                    const boost::program_options::options_description& options);

/// The list of the options.
std::string help_text(const boost::program_options::options_description& options);

/// The values of an option that may be repeated.
std::vector<std::string> files_in(const boost::program_options::variables_map& given, const std::string& option);

/// The setup that those options describe. Throws std::runtime_error (also as ConfigError) with one line for the user.
Setup setup_in(const boost::program_options::variables_map& given);

}  // namespace fourwis::benchmark
