#include "report.h"

#include <algorithm>

#include "fourwis_navigation/model/sentence.h"

namespace fourwis::referee
{

void Report::add(std::size_t point, double t, const std::string& what)
{
  if (full()) return;
  violations_.push_back({static_cast<int>(point), t, what});
  ++of_this_kind_;
}

void Report::add(std::size_t point, double t, const char* quantity, double value, double limit, const char* unit)
{
  if (full()) return;
  add(point, t, sentence("%s %.9g %s, limit %.9g %s", quantity, value, unit, limit, unit));
}

std::vector<Violation> Report::sorted() const
{
  std::vector<Violation> result = violations_;
  std::stable_sort(result.begin(), result.end(),
                   [](const Violation& a, const Violation& b) { return a.point < b.point; });
  return result;
}

}  // namespace fourwis::referee
