#pragma once

#include <string>
#include <vector>

#include "measurement.h"

namespace fourwis::benchmark
{

/// What the command line of benchmark_backend asks for.
struct BackendArguments
{
  std::string help;  ///< when not empty, the user asked for this text and for nothing else
  std::vector<std::string> problems;
  bool backend_only = false;
  bool environments = false;
  bool paper = false;
  bool markdown = false;
  Setup setup;
};

/// Throws std::runtime_error (also as boost's and ConfigError) with one line for the user.
BackendArguments parse_backend_arguments(int argc, const char* const* argv);

}  // namespace fourwis::benchmark
