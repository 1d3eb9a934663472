// problems/failing/cases.csv, with what its README says is right.

#include <cmath>
#include <iostream>
#include <limits>
#include <map>

#include "figures.h"
#include "problem_file.h"

namespace fourwis::nightly
{
namespace
{

constexpr double kAny = std::numeric_limits<double>::infinity();

/// What is right of an answer. Cases that are not named must succeed.
struct Right
{
  const char* id;
  double latest = kAny;  ///< arrival [s]
  double cpu = kAny;     ///< [s]
  bool modes = false;    ///< the time is reached with the issue on modes only
};

constexpr Right kRights[] = {
    {"short_wheelbase_sideways", 10.5, kAny, true},
    {"short_wheelbase_sideways_lateral", 10.5},
    {"phi_80_sideways", 4.3, kAny, true},
    {"phi_80_sideways_parallel", 4.3},
    {"phi_80_maze", 39.8},
    {"wider_than_long_sideways", 4.3, kAny, true},
    {"slow_switch_maze", kAny, 0.2},
    {"gap_67cm", kAny, 0.3},
    {"gap_68cm", kAny, 0.3},
    {"gap_63cm_no_margin", kAny, 0.3},
    {"gap_64cm_no_margin", kAny, 0.3},
    {"rooms", kAny, 0.3},
    {"turn_20mrad", 1.0, kAny, true},
    {"turn_1rad", 1.4, kAny, true},
    {"car1", kAny, 1.0},
    {"car1_all", kAny, 1.0},
    {"car4", kAny, 1.0},
    {"car7", kAny, 1.0},
    {"car9", kAny, 1.0},
    {"car9_all", kAny, 1.0},
    {"car20", kAny, 1.0},
    {"car20_all", kAny, 1.0},
    {"city", kAny, 0.3},
};

Right right_of(const std::string& id)
{
  for (const Right& right : kRights)
    if (right.id == id) return right;
  return {""};
}

std::string fault_in(const std::string& id, const Answer& answer, const Right& right)
{
  if (id == "off_the_map")
  {
    const bool names_it = answer.message.find("off the map") != std::string::npos;
    return answer.status == to_string(PlanStatus::goal_in_collision) && names_it ? "" : "it is off the map";
  }
  if (!answer.succeeded()) return "it can be done";
  if (answer.arrival > right.latest) return "it arrives after " + std::to_string(answer.arrival) + " s";
  if (answer.cpu > right.cpu) return "it takes " + std::to_string(answer.cpu) + " s CPU";
  if (id.rfind("car", 0) == 0 && answer.fallback_parts > 0) return "it stops to steer";
  return {};
}

}  // namespace

void failing_cases(const Figures& figures)
{
  const std::string file = "problems/failing/cases.csv";
  if (!figures.finds(file)) return;
  const std::vector<FileCase> entries = read_cases(figures.beside + "/" + file);
  std::vector<Question> questions;
  for (const FileCase& entry : entries)
    questions.push_back({entry.id, &entry.grid, entry.robot, entry.start, entry.goal, entry.modes});
  const std::vector<Answer> answers = ask_all(questions);
  Wrongs wrongs;
  std::map<std::string, double> arrival;
  std::string wrong_ones;
  int right_ones = 0, for_modes = 0;
  for (std::size_t k = 0; k < answers.size(); ++k)
  {
    const std::string& id = entries[k].id;
    wrongs.count(questions[k], answers[k], figures.cases);
    arrival[id] = answers[k].succeeded() ? answers[k].arrival : -1.0;
    const Right right = right_of(id);
    std::string fault = fault_in(id, answers[k], right);
    if (fault.empty() && (id == "far" || id == "utm_reference") && std::abs(arrival[id] - arrival["utm"]) > 1e-4)
      fault = "not the arrival time of utm";
    const bool later = !fault.empty() && right.modes && answers[k].succeeded();
    for_modes += later ? 1 : 0;
    right_ones += fault.empty() ? 1 : 0;
    if (fault.empty()) continue;
    figures.cases.add((later ? "for the issue on modes, " : "") + fault, questions[k], answers[k]);
    if (!later) wrong_ones += (wrong_ones.empty() ? ": " : ", ") + id;
  }
  figures.rows.add("failing/cases.csv", "all right but those for the issue on modes",
                   std::to_string(right_ones) + " of " + std::to_string(answers.size()) + " right, " +
                       std::to_string(for_modes) + " for the issue on modes" +
                       (wrong_ones.empty() ? "" : ", wrong" + wrong_ones),
                   wrong_ones.empty(), Rows::Weight::goal);
  wrongs.add_row("failing/cases.csv", figures.rows);
}

}  // namespace fourwis::nightly
