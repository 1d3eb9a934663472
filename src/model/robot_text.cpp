#include <cctype>
#include <cstring>
#include <locale>
#include <sstream>

#include "fourwis_navigation/model/option_range.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{
namespace
{

/// Reads lists of lists of numbers: JSON, as YAML and move_base write them.
class ListReader
{
public:
  explicit ListReader(const std::string& text) : stream_(text) { stream_.imbue(std::locale::classic()); }

  /// Whether the next character is this; if so, goes on behind it.
  bool take(char expected)
  {
    stream_ >> std::ws;
    if (stream_.peek() != expected) return false;
    stream_.get();
    return true;
  }

  bool point(Point2& point) { return take('[') && number(point.x) && take(',') && number(point.y) && take(']'); }

  bool ended()
  {
    stream_ >> std::ws;
    return stream_.eof() || stream_.peek() == std::char_traits<char>::eof();
  }

private:
  /// A leading zero means another number to YAML.
  bool number(double& value)
  {
    stream_ >> std::ws;
    std::string digits;
    while (std::isdigit(stream_.peek()) || (stream_.peek() > 0 && std::strchr("+-.eE", stream_.peek())))
      digits += static_cast<char>(stream_.get());
    const std::size_t first = digits.find_first_not_of("+-");
    if (first == std::string::npos) return false;
    if (digits[first] == '0' && first + 1 < digits.size() &&
        std::isdigit(static_cast<unsigned char>(digits[first + 1])))
      return false;
    std::istringstream text(digits);
    text.imbue(std::locale::classic());
    return static_cast<bool>(text >> value) && text.peek() == std::char_traits<char>::eof();
  }

  std::istringstream stream_;
};

bool is_within(double most, const Point2& point)
{
  const OptionRange range{-most, most};
  return range.contains(point.x) && range.contains(point.y);
}

}  // namespace

std::string PointText::expected() const
{
  return "two numbers [x, y] from " + limits_of({-most, most}) + " m";
}

std::string PointText::write(const Point2& point) const
{
  return '[' + to_text(point.x + 0.0) + ", " + to_text(point.y + 0.0) + ']';
}

bool PointText::read(const std::string& text, Point2& point) const
{
  ListReader reader(text);
  return reader.point(point) && reader.ended() && is_within(most, point);
}

std::string PolygonText::expected() const
{
  return "corners [[x, y], [x, y], ...] from " + limits_of({-most, most}) + " m, or [] for the rectangle";
}

std::string PolygonText::write(const std::vector<Point2>& polygon) const
{
  std::string text;
  for (const Point2& corner : polygon) text += (text.empty() ? "" : ", ") + PointText{most}.write(corner);
  return '[' + text + ']';
}

bool PolygonText::read(const std::string& text, std::vector<Point2>& polygon) const
{
  polygon.clear();
  ListReader reader(text);
  if (!reader.take('[')) return false;
  if (reader.take(']')) return reader.ended();
  do {
    Point2 corner{};
    if (!reader.point(corner) || !is_within(most, corner)) return false;
    polygon.push_back(corner);
  } while (reader.take(','));
  return reader.take(']') && reader.ended();
}

}  // namespace fourwis
