#include "rows.h"

#include <algorithm>
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
  rows_.push_back({holds ? "holds" : weight == Weight::wrong ? "WRONG" : "falls short", what, asked, measured});
  wrong_ += !holds && weight == Weight::wrong ? 1 : 0;
}

void Rows::note(const std::string& what, const std::string& measured)
{
  rows_.push_back({"", what, "", measured});
}

void Rows::print() const
{
  // The last column is as long as it has to be, so that it is not filled up.
  const std::vector<std::string> header = {"", "what", "asked", "measured"};
  std::vector<std::size_t> widths(header.size() - 1, 0);
  for (std::size_t column = 0; column < widths.size(); ++column)
    for (const std::vector<std::string>& row : rows_)
      widths[column] = std::max({widths[column], header[column].size(), row[column].size()});
  const auto print_row = [&](const std::vector<std::string>& row, char filling) {
    for (std::size_t column = 0; column < widths.size(); ++column)
      std::cout << "| " << row[column] << std::string(widths[column] - row[column].size(), filling) << ' ';
    std::cout << "| " << row.back() << " |\n";
  };
  print_row(header, ' ');
  print_row({"", "", "", "---"}, '-');
  for (const std::vector<std::string>& row : rows_) print_row(row, ' ');
  std::cout.flush();
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
