#include "parameter_list.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "fourwis_navigation/model/sentence.h"
#include "number_text.h"

namespace fourwis
{
namespace
{

std::string join(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<std::string> keys_of(const std::vector<Parameter>& parameters)
{
  std::vector<std::string> keys;
  keys.reserve(parameters.size());
  for (const Parameter& parameter : parameters) keys.push_back(parameter.key);
  return keys;
}

void reject_unknown(const ParameterMap& given, const std::vector<std::string>& keys,
                    const std::vector<std::string>& others)
{
  for (const auto& [key, value] : given)
  {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    std::vector<std::string> known = keys;
    known.insert(known.end(), others.begin(), others.end());
    reject<ConfigError>("unknown parameter '", key, "' (", text_of(value), "), expected only: ", join(known));
  }
}

}  // namespace

std::string text_of(const ParameterValue& value)
{
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const double* number = std::get_if<double>(&value)) return to_text(*number);
  return '\'' + std::get<std::string>(value) + '\'';
}

std::optional<double> plain_number(const ParameterValue& value)
{
  if (const double* number = std::get_if<double>(&value)) return *number;
  if (const std::string* text = std::get_if<std::string>(&value)) return number_in_text(*text);
  return std::nullopt;
}

bool flag_in(const std::string& key, const ParameterValue& value)
{
  const bool* flag = std::get_if<bool>(&value);
  if (!flag) reject_option(key, text_of(value), "true or false");
  return *flag;
}

double number_in(const std::string& key, const ParameterValue& value, const OptionRange& range)
{
  const std::optional<double> number = plain_number(value);
  if (!number) reject_option(key, text_of(value), expectation(range));
  require_in(range, key, *number);
  return *number;
}

void set_from(const ParameterMap& given, const std::vector<Parameter>& parameters,
              const std::vector<std::string>& others)
{
  reject_unknown(given, keys_of(parameters), others);
  try
  {
    for (const Parameter& parameter : parameters)
      if (const auto found = given.find(parameter.key); found != given.end()) parameter.set(found->second);
  }
  catch (const std::invalid_argument& error)
  {
    throw ConfigError(error.what());
  }
}

std::string defaults_taken(const ParameterMap& given, const std::vector<Parameter>& parameters)
{
  std::vector<std::string> taken;
  for (const Parameter& parameter : parameters)
    if (given.count(parameter.key) == 0 && !parameter.is_open) taken.push_back(parameter.key + " = " + parameter.value);
  return taken.empty() ? "" : "missing parameters take their defaults: " + join(taken);
}

}  // namespace fourwis
