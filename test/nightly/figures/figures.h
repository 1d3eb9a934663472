#pragma once

#include <string>
#include <vector>

#include "case_book.h"
#include "rows.h"

namespace fourwis::nightly
{

/// Has Figures::stopped() know of SIGINT and SIGTERM. Children ignore them.
void watch_signals();

/// What all parts of the figures are given.
struct Figures
{
  double share = 1.0;  ///< of everything: 0.1 is a tenth of the maps, robots and cases
  std::string beside;  ///< folder of third-party maps and problems; empty where there is none
  Rows& rows;
  CaseBook& cases;

  /// Whether the program was told to stop (SIGINT, SIGTERM): then what has been measured so far is all there is.
  static bool stopped();

  /// So many of them, at least one.
  int part_of(int count) const;

  /// A file of the folder beside the project. Says on the standard output that it is left out where it is missing.
  bool finds(const std::string& file) const;
};

/// Violations and verification_failed, which no part may have, and crashes.
class Wrongs
{
public:
  /// Counts, and keeps the case where something is wrong.
  void count(const Question& question, const Answer& answer, CaseBook& cases);

  void add_row(const std::string& what, Rows& rows) const;

private:
  int answers_ = 0, degraded_ = 0, violations_ = 0, refused_by_the_referee_ = 0, crashes_ = 0;
};

/// The rows of the table, part by part.
void floods_against_the_exact_body(const Figures& figures);
void failing_cases(const Figures& figures);
void random_pairs_of_the_default_robot(const Figures& figures);
void random_robots(const Figures& figures);
void parking_of_a_car(const Figures& figures);
void street_maps(const Figures& figures);

}  // namespace fourwis::nightly
