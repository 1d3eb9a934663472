#pragma once

#include <string>
#include <vector>

#include "measurement.h"

namespace fourwis::benchmark
{

/// What the command line asks for.
struct Arguments
{
  std::string help;  ///< when not empty, the user asked for this text and for nothing else
  std::vector<std::string> problems;
  bool environments = false;
  bool walled_in = false;
  bool ablation = false;
  std::string barn;
  std::string export_folder;
  std::vector<std::string> maps;
  bool corner_to_corner = false;
  bool markdown = false;
  Setup setup;
};

/// Throws std::runtime_error (also as boost's and ConfigError) with one line for the user.
Arguments parse_arguments(int argc, const char* const* argv);

}  // namespace fourwis::benchmark
