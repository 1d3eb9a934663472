// Long ways through cities with the default robot.

#include <cmath>
#include <iostream>

#include "city.h"
#include "figures.h"
#include "problem_file.h"

namespace fourwis::nightly
{
namespace
{

constexpr int kMaps = 42;
constexpr double kShortest = 80.0, kLongest = 750.0;  ///< ways [m]
constexpr double kLongestTime = 1.5;                  ///< CPU time of a plan [s]

class StreetFigures
{
public:
  explicit StreetFigures(const Figures& figures) : figures_(figures) {}

  void add(const Question& question, double way)
  {
    const Answer answer = ask_all({question}).front();
    wrongs_.count(question, answer, figures_.cases);
    ++count_;
    solved_ += answer.succeeded() ? 1 : 0;
    slow_ += answer.cpu > kLongestTime ? 1 : 0;
    with_stops_ += answer.fallback_parts > 0 ? 1 : 0;
    times_.push_back(answer.cpu);
    char text[160];
    std::snprintf(text, sizeof text, "%s: %d x %d cells of %.2f m, a way of %.0f m: %s, %.0f m in %.2f s CPU",
                  question.name.c_str(), question.grid->width, question.grid->height, question.grid->resolution, way,
                  answer.status.c_str(), answer.length, answer.cpu);
    std::cout << text << std::endl;
    if (!answer.succeeded() || answer.cpu > kLongestTime)
      figures_.cases.add(answer.succeeded() ? "street, slow" : "street", question, answer);
  }

  void add_rows() const
  {
    Rows& rows = figures_.rows;
    rows.add("street maps: verified", "all", share(solved_, count_), solved_ == count_, Rows::Weight::goal);
    rows.add("street maps: CPU p50 / p95 / p99 / max", "<= 1.5 s each",
             percentiles(times_) + ", " + std::to_string(slow_) + " above 1.5 s", slow_ == 0, Rows::Weight::goal);
    rows.note("street maps: some of it driven with stops (fallback_parts)", share(with_stops_, count_));
    wrongs_.add_row("street maps", rows);
  }

private:
  const Figures& figures_;
  Wrongs wrongs_;
  int count_ = 0, solved_ = 0, slow_ = 0, with_stops_ = 0;
  std::vector<double> times_;
};

}  // namespace

void street_maps(const Figures& figures)
{
  StreetFigures streets(figures);
  const int maps = figures.part_of(kMaps);
  for (int k = 0; k < maps && !Figures::stopped(); ++k)
  {
    const double way = maps == 1 ? kShortest : kShortest * std::pow(kLongest / kShortest, k / (maps - 1.0));
    const CityDrive drive = city_drive(k + 1, way, k % 2 == 0 ? 0.25 : 0.5);
    streets.add({drive.name, &drive.grid, Robot(), drive.start, drive.goal, ModeSet()}, drive.way);
  }
  const std::string file = "problems/failing/cases.csv";
  if (figures.finds(file))
    for (const FileCase& entry : read_cases(figures.beside + "/" + file))
      if (entry.id == "city")
        streets.add({"failing_city", &entry.grid, entry.robot, entry.start, entry.goal, entry.modes}, 83.0);
  streets.add_rows();
}

}  // namespace fourwis::nightly
