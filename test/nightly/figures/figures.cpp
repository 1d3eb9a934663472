#include "figures.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <iostream>

namespace fourwis::nightly
{

namespace
{

volatile std::sig_atomic_t stop = 0;

void on_signal(int)
{
  stop = 1;
}

}  // namespace

void watch_signals()
{
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool Figures::stopped()
{
  return stop != 0;
}

int Figures::part_of(int count) const
{
  return std::max(1, static_cast<int>(std::lround(share * count)));
}

bool Figures::finds(const std::string& file) const
{
  if (!beside.empty() && std::filesystem::exists(beside + "/" + file)) return true;
  std::cout << "  left out, as it is not there: " << beside << "/" << file << '\n';
  return false;
}

void Wrongs::count(const Question& question, const Answer& answer, CaseBook& cases)
{
  ++answers_;
  degraded_ += answer.degraded ? 1 : 0;
  const bool crashed = answer.status == "crashed";
  const bool refused = answer.status == to_string(PlanStatus::verification_failed);
  crashes_ += crashed ? 1 : 0;
  refused_by_the_referee_ += refused ? 1 : 0;
  violations_ += answer.violation.empty() ? 0 : 1;
  if (crashed) cases.add("CRASH", question, answer);
  if (refused) cases.add("REFUSED BY THE REFEREE", question, answer);
  if (!answer.violation.empty()) cases.add("VIOLATION", question, answer);
}

void Wrongs::add_row(const std::string& what, Rows& rows) const
{
  rows.add(what + ": violations; verification_failed; crashes", "0; 0; 0",
           std::to_string(violations_) + "; " + std::to_string(refused_by_the_referee_) + "; " +
               std::to_string(crashes_) + " of " + std::to_string(answers_) + " answers",
           violations_ + refused_by_the_referee_ + crashes_ == 0, Rows::Weight::wrong);
  if (degraded_ > 0) rows.note(what + ": cut short by the deadline", std::to_string(degraded_));
}

}  // namespace fourwis::nightly
