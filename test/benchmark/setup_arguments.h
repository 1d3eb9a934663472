#pragma once

#include <boost/program_options.hpp>

#include "measurement.h"

namespace fourwis::benchmark
{

/// Adds what all programs that measure have in common: runs, modes, robot, planner, markdown.
void add_setup_options(boost::program_options::options_description& options);

/// The setup that those options describe. Throws std::runtime_error (also as ConfigError) with one line for the user.
Setup setup_in(const boost::program_options::variables_map& given);

}  // namespace fourwis::benchmark
