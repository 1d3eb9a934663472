#include "fourwis_navigation/model/option_range.h"

#include <cstdlib>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{

std::string to_text(double number)
{
  std::string digits;
  for (int precision = 6; precision <= std::numeric_limits<double>::max_digits10; ++precision)
  {
    std::ostringstream text;
    text.precision(precision);
    text << number;
    digits = text.str();
    if (std::strtod(digits.c_str(), nullptr) == number) break;
  }
  return digits;
}

std::string limits_of(const OptionRange& range)
{
  return to_text(range.least) + " to " + to_text(range.greatest);
}

std::string expectation(const OptionRange& range)
{
  const std::string unit = range.unit;
  return (range.whole ? "a whole number from " : "a number from ") + limits_of(range) + (unit.empty() ? "" : " ") +
         unit;
}

void reject_option(const std::string& option, const std::string& value, const std::string& expected)
{
  reject<std::invalid_argument>("parameter '", option, "' is ", value, ", expected ", expected);
}

void require_positive(const std::string& argument, double value)
{
  if (!(value > 0.0) || std::isinf(value)) reject_option(argument, to_text(value), "a positive, finite number");
}

}  // namespace fourwis
