#include "rows.h"

#include <iostream>

#include "../../benchmark/statistics.h"
#include "../../benchmark/table.h"

namespace fourwis::nightly
{

using benchmark::fixed;
using benchmark::quantile;

void Rows::add(const std::string& what, const std::string& asked, const std::string& measured, bool holds,
               Weight weight)
{
  rows_.push_back({what, asked, measured, holds ? "holds" : weight == Weight::wrong ? "WRONG" : "falls short"});
  wrong_ += !holds && weight == Weight::wrong ? 1 : 0;
}

void Rows::note(const std::string& what, const std::string& measured)
{
  rows_.push_back({what, "", measured, ""});
}

void Rows::print() const
{
  benchmark::Table table({"what", "asked", "measured", ""});
  for (const std::vector<std::string>& row : rows_) table.add(row);
  table.print(std::cout, true);
}

std::string share(int part, int whole)
{
  const std::string counts = std::to_string(part) + " of " + std::to_string(whole);
  return whole == 0 ? counts : counts + " (" + fixed(100.0 * part / whole, 1) + " %)";
}

std::string percentiles(const std::vector<double>& seconds)
{
  std::string text;
  for (double q : {0.5, 0.95, 0.99, 1.0}) text += (q > 0.5 ? " / " : "") + fixed(1e3 * quantile(seconds, q), 0);
  return text + " ms";
}

bool percentiles_hold(const std::vector<double>& seconds, double median, double p95, double p99, double most)
{
  return !seconds.empty() && quantile(seconds, 0.5) <= median && quantile(seconds, 0.95) <= p95 &&
         quantile(seconds, 0.99) <= p99 && quantile(seconds, 1.0) <= most;
}

}  // namespace fourwis::nightly
