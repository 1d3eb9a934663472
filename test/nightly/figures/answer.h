#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::nightly
{

/// A problem of its own: what `plan` can be asked again.
struct Question
{
  std::string name;  ///< of the problem; it can be the name of a file
  const OccupancyGrid* grid = nullptr;
  Robot robot;
  Pose start, goal;
  ModeSet modes;
};

struct Answer
{
  std::string status = "crashed";
  std::string message;
  double cpu = 0.0;      ///< of the process, map included [s]
  double arrival = 0.0;  ///< [s]
  double length = 0.0;   ///< [m]
  int fallback_parts = 0;
  bool degraded = false;  ///< whether the deadline cut the work short
  std::string violation;  ///< what is wrong with the trajectory, seen by code of its own; empty where nothing is

  bool succeeded() const { return status == to_string(PlanStatus::succeeded); }
};

/// Plans with the default options, in one thread and with a patience that a loaded machine does not use up.
Answer ask(const Question& question);

/// The answers to all questions, each planned in a child process; "crashed" where the planner did.
std::vector<Answer> ask_all(const std::vector<Question>& questions);

/// What `plan` would be given.
std::string described(const Question& question);

}  // namespace fourwis::nightly
