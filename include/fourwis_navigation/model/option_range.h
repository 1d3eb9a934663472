#pragma once

#include <cmath>
#include <string>

namespace fourwis
{

/// What a number may be.
struct OptionRange
{
  double least, greatest;
  const char* unit = "";  ///< of both; empty where there is none
  bool whole = false;     ///< whether fractions are rejected

  /// False for NaN.
  bool contains(double value) const
  {
    return value >= least && value <= greatest && (!whole || value == std::floor(value));
  }
};

/// The fewest digits, 6 or more, that read back as the same number.
std::string to_text(double number);

/// "0.01 to 20"
std::string limits_of(const OptionRange& range);

/// "a number from 0.01 to 20 m/s"
std::string expectation(const OptionRange& range);

/// Throws std::invalid_argument: "parameter 'step_time' is 0, expected a number from 0.01 to 10 s". All that is wrong with an
/// option is said in this form.
[[noreturn]] void reject_option(const std::string& option, const std::string& value, const std::string& expected);

/// The one check of a range: throws std::invalid_argument, naming option, value and range, for what it does not contain.
inline void require_in(const OptionRange& range, const std::string& option, double value)
{
  if (!range.contains(value)) reject_option(option, to_text(value), expectation(range));
}

/// The same for an argument that only has to be a positive, finite number.
void require_positive(const std::string& argument, double value);

}  // namespace fourwis
