#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fourwis_navigation/referee/referee.h"

namespace fourwis::referee
{

/// Collects violations, but only a few of each kind, because a trajectory may be wrong at every point.
class Report
{
public:
  /// Violations added from now on are of another kind.
  void next_kind() { of_this_kind_ = 0; }

  bool full() const { return of_this_kind_ >= kMostOfOneKind; }

  void add(std::size_t point, double t, const std::string& what);

  /// "QUANTITY VALUE UNIT, limit LIMIT UNIT".
  void add(std::size_t point, double t, const char* quantity, double value, double limit, const char* unit);

  /// All violations in the order of the points.
  std::vector<Violation> sorted() const;

private:
  static constexpr int kMostOfOneKind = 5;

  std::vector<Violation> violations_;
  int of_this_kind_ = 0;
};

}  // namespace fourwis::referee
