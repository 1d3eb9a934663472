#include "parameter_list.h"

#include <algorithm>
#include <stdexcept>

#include "fourwis_navigation/model/sentence.h"

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

void reject_missing(const ParameterMap& given, const std::vector<std::string>& keys)
{
  std::vector<std::string> missing;
  for (const std::string& key : keys)
    if (given.count(key) == 0) missing.push_back(key);
  if (!missing.empty()) reject<ConfigError>("missing parameter ", join(missing));
}

}  // namespace

std::string text_of(const ParameterValue& value)
{
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const double* number = std::get_if<double>(&value)) return to_text(*number);
  return '\'' + std::get<std::string>(value) + '\'';
}

bool flag_in(const std::string& key, const ParameterValue& value)
{
  const bool* flag = std::get_if<bool>(&value);
  if (!flag) reject_option(key, text_of(value), "true or false");
  return *flag;
}

double number_in(const std::string& key, const ParameterValue& value, const OptionRange& range)
{
  const double* number = std::get_if<double>(&value);
  if (!number) reject_option(key, text_of(value), expectation(range));
  require_in(range, key, *number);
  return *number;
}

void set_from(const ParameterMap& given, const std::vector<Parameter>& parameters, Missing missing,
              const std::vector<std::string>& others)
{
  const std::vector<std::string> keys = keys_of(parameters);
  reject_unknown(given, keys, others);
  if (missing == Missing::is_rejected) reject_missing(given, keys);
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

}  // namespace fourwis
