// A car-sized robot that parks: it must get there, smoothly and soon, also where it can only drive like a car.

#include <iostream>

#include "figures.h"
#include "parking.h"
#include "problem_file.h"

namespace fourwis::nightly
{
namespace
{

constexpr int kCases = 20;
constexpr double kLongest = 1.0;  ///< CPU time of a plan [s]

/// One set of modes over all cases.
struct CarFigures
{
  std::string what;
  ModeSet modes;
  double asked;  ///< share of the cases
  int solved = 0, count = 0, with_stops = 0, slow = 0;
  std::vector<double> times = {};

  void add(const Question& question, const Answer& answer, CaseBook& cases)
  {
    ++count;
    solved += answer.succeeded() ? 1 : 0;
    with_stops += answer.fallback_parts > 0 ? 1 : 0;
    slow += answer.cpu > kLongest ? 1 : 0;
    times.push_back(answer.cpu);
    if (!answer.succeeded())
      cases.add("car", question, answer);
    else if (answer.fallback_parts > 0)
      cases.add("car, " + std::to_string(answer.fallback_parts) + " fallback_parts", question, answer);
    else if (answer.cpu > kLongest)
      cases.add("car, slow", question, answer);
  }

  void add_rows(Rows& rows) const
  {
    const std::string least = asked < 1.0 ? ">= " + std::to_string(static_cast<int>(100.0 * asked)) + " %" : "all";
    rows.add(what + ": verified", least, share(solved, count), solved >= asked * count, Rows::Weight::goal);
    rows.add(what + ": driven with stops (fallback_parts)", "none", share(with_stops, count), with_stops == 0,
             Rows::Weight::goal);
    rows.add(what + ": CPU p50 / p95 / p99 / max", "<= 1 s each",
             percentiles(times) + ", " + std::to_string(slow) + " above 1 s", slow == 0, Rows::Weight::goal);
  }
};

/// The generated ones, and the third party's where they are.
std::vector<ParkingCase> all_cases(const Figures& figures)
{
  std::vector<ParkingCase> cases = parking_cases(figures.part_of(kCases));
  const std::string file = "problems/failing/cases.csv";
  if (!figures.finds(file)) return cases;
  for (const FileCase& entry : read_cases(figures.beside + "/" + file))
    if (entry.id.rfind("car", 0) == 0 && entry.id.find("_all") == std::string::npos)
      cases.push_back({"failing_" + entry.id, entry.grid, entry.start, entry.goal});
  return cases;
}

}  // namespace

void parking_of_a_car(const Figures& figures)
{
  Wrongs wrongs;
  CarFigures all{"car that parks, all modes", ModeSet(), 1.0};
  CarFigures alone{"car that parks, Ackermann alone", ModeSet{kCarMode}, 0.9};
  const std::vector<ParkingCase> cases = all_cases(figures);
  for (CarFigures* figure : {&all, &alone})
  {
    std::vector<Question> questions;
    for (const ParkingCase& place : cases)
      questions.push_back({place.name + (figure == &all ? "" : "#ackermann"), &place.grid, car(), place.start,
                           place.goal, figure->modes});
    const std::vector<Answer> answers = ask_all(questions);
    for (std::size_t k = 0; k < answers.size(); ++k)
    {
      wrongs.count(questions[k], answers[k], figures.cases);
      figure->add(questions[k], answers[k], figures.cases);
    }
    figure->add_rows(figures.rows);
  }
  wrongs.add_row("car that parks", figures.rows);
}

}  // namespace fourwis::nightly
