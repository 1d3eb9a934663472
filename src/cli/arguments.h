#pragma once

#include <stdexcept>
#include <string>

#include "fourwis_navigation/map/octomap_projection.h"
#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// What the command line of `plan` asks for. An empty file name stands for an output that is not asked for.
struct PlanArguments
{
  std::string text;     ///< when not empty, the user asked for this text and for nothing else: help, list of parameters
  std::string map;      ///< map_server YAML; exactly one of `map` and `octomap` is set
  std::string octomap;  ///< OctoMap file
  HeightBand band;      ///< heights of the OctoMap that matter
  Pose start, goal;     ///< map frame
  std::string robot;    ///< robot.yaml; the defaults of Robot when empty
  std::string planner;  ///< planner.yaml; the defaults of PlannerOptions when empty
  ModeSet modes;
  bool frontend_only = false;  ///< stop after the front end's own trajectory
  bool corridors = false;      ///< draw the corridors in the SVG
  bool iterations = false;     ///< draw what each round of the optimisation made of the path in the SVG
  int repeat = 1;              ///< plan so many times and report the medians of the times
  std::string json;            ///< "-" is the standard output
  std::string csv;
  std::string svg;
};

/// Wrong use of the command line. what() is one line that names the argument and what was expected.
struct UsageError : std::runtime_error
{
  UsageError(const std::string& what, const std::string& json_file) : std::runtime_error(what), json(json_file) {}

  std::string json;  ///< where the user wants the JSON, as far as that could be read
};

/// Reads a command line whose first word is the program's name. Throws UsageError.
PlanArguments parse_arguments(int argc, const char* const* argv);

}  // namespace fourwis
