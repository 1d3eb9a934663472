#include "table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fourwis::benchmark
{
namespace
{

void print_row(std::ostream& out, const std::vector<std::string>& row, const std::vector<std::size_t>& widths,
               bool markdown)
{
  for (std::size_t c = 0; c < row.size(); ++c)
  {
    const std::string padding(widths[c] - row[c].size(), ' ');
    out << (markdown ? "| "
            : c > 0  ? "  "
                     : "")
        << (c == 0 ? row[c] + padding : padding + row[c]) << (markdown ? " " : "");
  }
  out << (markdown ? "|\n" : "\n");
}

void print_rule(std::ostream& out, const std::vector<std::size_t>& widths, bool markdown)
{
  for (std::size_t c = 0; c < widths.size(); ++c)
  {
    if (markdown)
      out << (c == 0 ? "|:" + std::string(widths[c] + 1, '-') : "|" + std::string(widths[c] + 1, '-') + ":");
    else
      out << (c > 0 ? "  " : "") << std::string(widths[c], '-');
  }
  out << (markdown ? "|\n" : "\n");
}

}  // namespace

void Table::print(std::ostream& out, bool markdown) const
{
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const auto& row : rows_)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  for (std::size_t r = 0; r < rows_.size(); ++r)
  {
    print_row(out, rows_[r], widths, markdown);
    if (r == 0) print_rule(out, widths, markdown);
  }
}

std::string fixed(double value, int decimals)
{
  if (!std::isfinite(value)) return "-";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

void Report::title(const std::string& text) const
{
  out << (markdown ? "### " + text : text) << "\n\n";
}

void Report::table(const Table& table) const
{
  table.print(out, markdown);
  out << '\n';
}

void Report::line(const std::string& text) const
{
  out << text << "\n\n" << std::flush;
}

}  // namespace fourwis::benchmark
