#include "parameter_table.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace fourwis
{
namespace
{

std::string text_of(const ParameterValue& value)
{
  std::ostringstream text;
  if (const bool* flag = std::get_if<bool>(&value)) text << (*flag ? "true" : "false");
  if (const double* number = std::get_if<double>(&value)) text << *number;
  if (const std::string* word = std::get_if<std::string>(&value)) text << '\'' << *word << '\'';
  return text.str();
}

std::string join(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

[[noreturn]] void refuse(const std::string& key, const ParameterValue& value, const std::string& expected)
{
  throw ConfigError("parameter '" + key + "' is " + text_of(value) + ", expected " + expected);
}

void assign_text(const std::string& key, const ParameterValue& value, std::string& target)
{
  const std::string* text = std::get_if<std::string>(&value);
  if (!text || text->empty()) refuse(key, value, "a word");
  target = *text;
}

void assign_choice(const std::string& key, const ParameterValue& value, const Choice& choice)
{
  const std::string* word = std::get_if<std::string>(&value);
  const auto found = word ? std::find(choice.words.begin(), choice.words.end(), *word) : choice.words.end();
  if (found == choice.words.end()) refuse(key, value, "one of " + join(choice.words));
  choice.choose(static_cast<std::size_t>(found - choice.words.begin()));
}

}  // namespace

void check_keys(const std::vector<std::string>& keys, const ParameterMap& parameters)
{
  for (const auto& [key, value] : parameters)
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      throw ConfigError("unknown parameter '" + key + "' (" + text_of(value) + "), expected only: " + join(keys));

  std::vector<std::string> missing;
  for (const std::string& key : keys)
    if (parameters.count(key) == 0) missing.push_back(key);
  if (!missing.empty()) throw ConfigError("missing parameter " + join(missing));
}

void assign(const std::string& key, const ParameterValue& value, double min, double max, const std::string& unit,
            const Slot& slot)
{
  if (bool* const* flag = std::get_if<bool*>(&slot))
  {
    if (!std::holds_alternative<bool>(value)) refuse(key, value, "true or false");
    **flag = std::get<bool>(value);
    return;
  }

  if (std::string* const* text = std::get_if<std::string*>(&slot)) return assign_text(key, value, **text);
  if (const Choice* choice = std::get_if<Choice>(&slot)) return assign_choice(key, value, *choice);

  const bool whole = std::holds_alternative<int*>(slot);
  std::ostringstream expected;
  expected.precision(10);
  expected << (whole ? "a whole number from " : "a number from ") << min << " to " << max
           << (unit.empty() ? "" : " " + unit);

  const double* number = std::get_if<double>(&value);
  // Written so that NaN, too, is refused.
  if (!number || !(*number >= min && *number <= max)) refuse(key, value, expected.str());
  if (whole && *number != std::floor(*number)) refuse(key, value, expected.str());

  if (int* const* target = std::get_if<int*>(&slot))
    **target = static_cast<int>(*number);
  else
    *std::get<double*>(slot) = *number;
}

}  // namespace fourwis
