#include "legend.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{
namespace
{

constexpr double kMargin = 16.0;
constexpr double kCharacterWidth = 8.0;  ///< of the 13 px font, on average

/// Width of a label in that font, near enough to set labels side by side [px].
double width_of(const std::string& label)
{
  double width = 0.0;
  for (const char c : label) width += std::string("iljtfr ").find(c) != std::string::npos ? 4.5 : c == 'm' ? 12.5 : 8.0;
  return width;
}

std::string escaped(const std::string& text)
{
  std::string safe;
  for (const char c : text)
  {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else
      // XML has neither control characters nor, in a file of ours, bytes that may not be UTF-8.
      safe += c >= ' ' && c <= '~' ? c : '?';
  }
  return safe;
}

/// What became of the plan, in one line.
std::string headline(const PlanResult& result)
{
  if (result.status != PlanStatus::succeeded) return result.message;
  const PlanMetrics& metrics = result.metrics;
  return sentence("%.2f m, %.1f s, %d mode switch%s, clearance %.2f m, planned in %.1f ms", metrics.length,
                  metrics.arrival_time, metrics.switches, metrics.switches == 1 ? "" : "es", metrics.min_clearance,
                  metrics.total_ms);
}

/// Writes the entries of the legend from left to right.
class Entries
{
public:
  Entries(std::ostream& out, double y) : out_(out), y_(y) {}

  void line(const std::string& colour, const std::string& label)
  {
    out_ << "<path d=\"M" << pixels(x_) << ',' << pixels(y_) << "h26\" stroke=\"" << colour
         << "\" stroke-width=\"4\" stroke-linecap=\"round\"/>\n";
    text(34.0, label);
  }
  void arrow(const char* colour, const std::string& label)
  {
    out_ << "<path d=\"M" << pixels(x_) << ',' << pixels(y_ - 6.0) << "l16,6l-16,6l5,-6z\" fill=\"" << colour
         << "\"/>\n";
    text(22.0, label);
  }
  void ring(const std::string& label)
  {
    out_ << "<circle cx=\"" << pixels(x_ + 6.0) << "\" cy=\"" << pixels(y_) << "\" r=\"4.5\" fill=\"#ffffff\" stroke=\""
         << kStartColour << "\" stroke-width=\"2\"/>\n";
    text(18.0, label);
  }
  void box(const char* colour, const std::string& label)
  {
    out_ << "<rect x=\"" << pixels(x_) << "\" y=\"" << pixels(y_ - 7.0) << "\" width=\"14\" height=\"14\" fill=\""
         << colour << "\" stroke=\"#8a919c\" stroke-width=\"0.5\"/>\n";
    text(21.0, label);
  }

private:
  void text(double offset, const std::string& label)
  {
    out_ << "<text x=\"" << pixels(x_ + offset) << "\" y=\"" << pixels(y_ + 4.5) << "\">" << escaped(label)
         << "</text>\n";
    x_ += offset + width_of(label) + 20.0;
  }

  std::ostream& out_;
  double x_ = kMargin, y_;
};

/// A bar of 1, 2 or 5 times a power of ten metres, at the right end of the first line.
void write_scale_bar(std::ostream& out, const Page& page, double y)
{
  const double most = 120.0 / page.scale;
  double metres = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
  {
    if (metres * factor > most) continue;
    metres *= factor;
    break;
  }
  const double length = metres * page.scale, x = page.width - kMargin - length;
  out << "<path d=\"M" << pixels(x) << ',' << pixels(y - 4.0) << "v8m0,-4h" << pixels(length) << "m0,-4v8\" stroke=\""
      << kStartColour << "\" stroke-width=\"1.5\" fill=\"none\"/>\n"
      << "<text text-anchor=\"end\" x=\"" << pixels(x - 8.0) << "\" y=\"" << pixels(y + 4.5) << "\">"
      << sentence("%g m", metres) << "</text>\n";
}

std::string shortened(const std::string& text, double width)
{
  const auto room = static_cast<std::size_t>(std::max(width / kCharacterWidth, 10.0));
  return text.size() <= room ? text : text.substr(0, room - 3) + "...";
}

}  // namespace

void write_legend(std::ostream& out, const Page& page, const PlanPicture& picture)
{
  const PlanResult& result = picture.result;
  const double first = page.map_height + 25.0, second = page.map_height + 53.0;
  const std::string status = to_string(result.status);
  out << "<g font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"" << kStartColour
      << "\">\n"
      << "<text x=\"" << pixels(kMargin) << "\" y=\"" << pixels(first + 4.5) << "\"><tspan font-weight=\"bold\">"
      << status << "</tspan><tspan dx=\"10\">"
      << escaped(shortened(headline(result), page.width - 200.0 - kCharacterWidth * static_cast<double>(status.size())))
      << "</tspan></text>\n";
  write_scale_bar(out, page, first);

  Entries entries(out, second);
  for (const Mode mode : kPlannedModes) entries.line(svg_colour(mode), to_string(mode));
  entries.ring("mode switch");
  entries.arrow(kStartColour, "start");
  entries.arrow(kGoalColour, "goal");
  entries.box(kOccupiedColour, "occupied");
  entries.box(kUnknownColour, "unknown");
  if (!picture.corridors.empty()) entries.box(kCorridorColour, "corridors");
  if (!picture.iterations.empty()) entries.line(kIterationColour, "iterations");
  out << "</g>\n";
}

}  // namespace fourwis
