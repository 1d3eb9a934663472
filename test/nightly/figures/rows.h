#pragma once

#include <string>
#include <vector>

namespace fourwis::nightly
{

/// The rows of issue 10's table "Figures": what was asked beside what was measured.
class Rows
{
public:
  /// Whether a row that falls short makes the program fail: what is wrong always does, a share or a time does not, because
  /// those are goals on the way.
  enum class Weight
  {
    wrong,
    goal
  };

  void add(const std::string& what, const std::string& asked, const std::string& measured, bool holds, Weight weight);

  /// A figure that nothing is asked of.
  void note(const std::string& what, const std::string& measured);

  void print() const;

  /// Whether no answer was wrong.
  bool all_right() const { return wrong_ == 0; }

private:
  std::vector<std::vector<std::string>> rows_;
  int wrong_ = 0;
};

/// "12 of 34 (35.3 %)".
std::string share(int part, int whole);

/// "1 / 2 / 3 / 4 ms": the median, 95 %, 99 % and the greatest of times in seconds.
std::string percentiles(const std::vector<double>& seconds);

/// Whether they are at most these, in seconds.
bool percentiles_hold(const std::vector<double>& seconds, double median, double p95, double p99, double most);

}  // namespace fourwis::nightly
