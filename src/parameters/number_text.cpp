#include "number_text.h"

#include <cmath>
#include <locale>
#include <regex>
#include <sstream>

namespace fourwis
{
namespace
{

const std::string kDigits = R"((?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)";
const std::string kPlain = "(?!0[0-9])" + kDigits;

std::string without_spaces_around(const std::string& text)
{
  const char* const spaces = " \t";
  const std::size_t first = text.find_first_not_of(spaces);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

/// Sums of products of numbers and pi. Evaluated from left to right as Python does, so that the last bit is the same.
class Expression
{
public:
  explicit Expression(const std::string& text) : rest_(text) {}

  std::optional<double> value()
  {
    const double result = sum();
    if (!take("$")) return std::nullopt;
    return result;
  }

private:
  double sum()
  {
    double result = product();
    while (take("[-+]")) result += taken_ == "-" ? -product() : product();
    return result;
  }

  double product()
  {
    double result = factor();
    while (take("[*/]"))
    {
      const bool divides = taken_ == "/";
      const double next = factor();
      result = divides ? result / next : result * next;
    }
    return result;
  }

  double factor()
  {
    double sign = 1.0;
    while (take("[-+]")) sign = taken_ == "-" ? -sign : sign;
    if (take("pi")) return sign * M_PI;
    return take(kPlain) ? sign * decimal(taken_) : NAN;
  }

  /// Goes on behind what matches here, after spaces; what matched is taken_.
  bool take(const std::string& pattern)
  {
    std::smatch match;
    if (!std::regex_search(rest_, match, std::regex("[ \t]*(" + pattern + ")"), std::regex_constants::match_continuous))
      return false;
    taken_ = match[1];
    rest_ = match.suffix();
    return true;
  }

  std::string rest_, taken_;
};

}  // namespace

double decimal(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  stream >> number;
  return number;
}

std::optional<double> number_in_text(const std::string& text)
{
  static const std::regex number("[-+]?" + kPlain);
  if (!std::regex_match(text, number)) return std::nullopt;
  return decimal(text);
}

std::optional<double> degrees_in_text(const std::string& text)
{
  static const std::regex number("[-+]?" + kDigits);
  const std::string degrees = without_spaces_around(text);
  if (!std::regex_match(degrees, number)) return std::nullopt;
  return decimal(degrees) * M_PI / 180.0;
}

std::optional<double> radians_in_text(const std::string& text)
{
  const std::optional<double> value = Expression(text).value();
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace fourwis
