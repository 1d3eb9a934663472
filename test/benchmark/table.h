#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace fourwis::benchmark
{

/// Rows of text in columns: the first column flush left, the others flush right.
class Table
{
public:
  explicit Table(std::vector<std::string> header) : rows_{std::move(header)} {}

  /// `row` has as many cells as the header.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

  void print(std::ostream& out, bool markdown) const;

private:
  std::vector<std::vector<std::string>> rows_;  ///< the header first
};

/// A number with that many decimals; "-" when it is not finite.
std::string fixed(double value, int decimals);

/// Where tables and the sentences between them go.
struct Report
{
  std::ostream& out;
  bool markdown;

  void title(const std::string& text) const;
  void table(const Table& table) const;
  /// A line of text below a table.
  void line(const std::string& text) const;
};

}  // namespace fourwis::benchmark
