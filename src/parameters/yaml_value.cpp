#include "yaml_value.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>
#include <optional>
#include <regex>
#include <sstream>

#include "fourwis_navigation/model/option_range.h"
#include "number_text.h"

namespace fourwis
{
namespace
{

/// The patterns of PyYAML's resolver, and rosparam's of an angle.
struct Patterns
{
  const std::regex whole{"[-+]?(?:0b[01_]+|0x[0-9a-fA-F_]+|0[0-7_]+|0|[1-9][0-9_]*(?::[0-5]?[0-9])*)"};
  const std::regex floating{
      "[-+]?[0-9][0-9_]*\\.[0-9_]*(?:[eE][-+][0-9]+)?|\\.[0-9][0-9_]*(?:[eE][-+][0-9]+)?|"
      "[-+]?[0-9][0-9_]*(?::[0-5]?[0-9])+\\.[0-9_]*"};
  const std::regex infinite{"[-+]?\\.(?:inf|Inf|INF)"};
  const std::regex no_number{"\\.(?:nan|NaN|NAN)"};
  const std::regex yes{"yes|Yes|YES|true|True|TRUE|on|On|ON"};
  const std::regex no{"no|No|NO|false|False|FALSE|off|Off|OFF"};
  const std::regex angle{"(deg|rad)\\(([^)]*)\\)"};
};

const Patterns& patterns()
{
  static const Patterns compiled;
  return compiled;
}

bool is(const std::string& text, const std::regex& pattern)
{
  return std::regex_match(text, pattern);
}

double digits(const std::string& text, int base)
{
  double value = 0.0;
  for (const char c : text) value = base * value + (c <= '9' ? c - '0' : std::tolower(c) - 'a' + 10);
  return value;
}

/// Parts of 60, as of hours, minutes and seconds; a number without colons is one part.
double in_parts(const std::string& text)
{
  double value = 0.0;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ':');) value = 60.0 * value + decimal(part);
  return value;
}

double magnitude(const std::string& text, bool whole)
{
  const bool has_base = whole && text.size() > 1 && text.front() == '0';
  if (!has_base) return in_parts(text);
  if (text[1] == 'b') return digits(text.substr(2), 2);
  if (text[1] == 'x') return digits(text.substr(2), 16);
  return digits(text, 8);
}

double number(std::string text, bool whole)
{
  text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
  const bool has_sign = text.front() == '-' || text.front() == '+';
  const double size = magnitude(text.substr(has_sign ? 1 : 0), whole);
  return text.front() == '-' ? -size : size;
}

/// The parameter server has no more: roslaunch ends on a larger one without saying which.
double whole_number(const std::string& key, const std::string& text)
{
  const double value = number(text, true);
  using Limits = std::numeric_limits<std::int32_t>;
  if (value < Limits::min() || value > Limits::max())
    reject_option(key, text, "a whole number of at most 31 bits, or one with a decimal point");
  return value;
}

/// `inner` is what stands in the parentheses of an angle, or behind its tag.
double angle(const std::string& key, const std::string& text, bool in_degrees, const std::string& inner)
{
  const std::optional<double> value = in_degrees ? degrees_in_text(inner) : radians_in_text(inner);
  if (!value) reject_option(key, text, in_degrees ? "a number of degrees" : "radians: numbers and pi with + - * /");
  return *value;
}

}  // namespace

ParameterValue yaml_value(const std::string& key, const std::string& tag, const std::string& text)
{
  const double infinity = std::numeric_limits<double>::infinity();
  if (tag == "!") return text;  // quoted
  if (tag == "!degrees" || tag == "!radians") return angle(key, text, tag == "!degrees", text);
  if (tag != "?" && !tag.empty()) reject_option(key, text + " with the tag " + tag, "a value without a tag");
  if (is(text, patterns().whole)) return whole_number(key, text);
  if (is(text, patterns().floating)) return number(text, false);
  if (is(text, patterns().infinite)) return text.front() == '-' ? -infinity : infinity;
  if (is(text, patterns().no_number)) return std::numeric_limits<double>::quiet_NaN();
  if (is(text, patterns().yes)) return true;
  if (is(text, patterns().no)) return false;
  std::smatch parts;
  if (std::regex_match(text, parts, patterns().angle)) return angle(key, text, parts[1] == "deg", parts[2]);
  return text;
}

}  // namespace fourwis
