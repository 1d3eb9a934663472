#pragma once

#include <set>
#include <string>

#include "answer.h"

namespace fourwis::nightly
{

/// Keeps the problems whose answers are wrong or slow, so that `plan` can be asked again: a line on the standard output, and,
/// where there is a folder, the map, the robot and a line in its cases.csv, `id;map;start;goal;robot;modes;said`.
class CaseBook
{
public:
  /// An empty folder: only the lines. Throws std::runtime_error where the folder cannot be made.
  explicit CaseBook(const std::string& folder);

  void add(const std::string& why, const Question& question, const Answer& answer);

private:
  std::string map_of(const Question& question);

  std::string folder_;
  std::set<std::string> ids_;
};

}  // namespace fourwis::nightly
