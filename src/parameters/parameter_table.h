#pragma once

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{

/// A parameter that is one of a few words.
struct Choice
{
  std::vector<std::string> words;
  std::function<void(std::size_t)> choose;  ///< takes the position of the word
};

/// For an enumeration whose values are counted from 0 in the order of the words.
template <class Value>
Choice choice(Value& target, std::vector<std::string> words)
{
  return {std::move(words), [&target](std::size_t i) { target = static_cast<Value>(i); }};
}

/// The member that a parameter sets.
using Slot = std::variant<bool*, int*, double*, std::string*, Choice>;

/// One key of a configuration file and the member of Options it sets.
template <class Options>
struct Parameter
{
  std::string key;
  std::function<Slot(Options&)> slot;
  double min = 0.0, max = 1.0;  ///< least and greatest value allowed, of numbers
  std::string unit = "";        ///< as it appears in error texts
};

template <class Options>
using ParameterTable = std::vector<Parameter<Options>>;

/// Throws ConfigError unless `parameters` has exactly `keys`.
void check_keys(const std::vector<std::string>& keys, const ParameterMap& parameters);

/// Writes `value` to `slot`. Throws ConfigError when it has the wrong type or lies outside `min` to `max`.
void assign(const std::string& key, const ParameterValue& value, double min, double max, const std::string& unit,
            const Slot& slot);

/// An Options in which every row of the table is set from `parameters`; throws ConfigError.
template <class Options>
Options options_from(const ParameterTable<Options>& table, const ParameterMap& parameters)
{
  std::vector<std::string> keys;
  for (const Parameter<Options>& row : table) keys.push_back(row.key);
  check_keys(keys, parameters);

  Options options;
  for (const Parameter<Options>& row : table)
    assign(row.key, parameters.at(row.key), row.min, row.max, row.unit, row.slot(options));
  return options;
}

}  // namespace fourwis
