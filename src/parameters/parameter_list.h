#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "fourwis_navigation/model/option_range.h"
#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{

/// One key of a configuration and the member that it sets.
struct Parameter
{
  std::string key;
  std::string value;  ///< what the member is
  std::string range;  ///< what it may be
  std::string unit;
  /// Throws std::invalid_argument naming key, value and what was expected.
  std::function<void(const ParameterValue&)> set;
  bool is_open = false;  ///< not set unless given
};

/// As it appears in error texts.
std::string text_of(const ParameterValue& value);

/// A number, also one that is written as a text: PyYAML takes 2e-2 for one, and there are people who put numbers into quotes.
std::optional<double> plain_number(const ParameterValue& value);

bool flag_in(const std::string& key, const ParameterValue& value);
double number_in(const std::string& key, const ParameterValue& value, const OptionRange& range);

/// A reader of a struct's describe() (model/option_check.h) that lists its keys.
class ParameterList
{
public:
  /// The list refers to the options.
  template <class Options>
  static std::vector<Parameter> of(Options& options)
  {
    ParameterList row;
    Options::describe(options, row);
    return std::move(row.parameters_);
  }

  void operator()(std::string_view key, bool& value)
  {
    const std::string name = prefix_ + std::string(key);
    parameters_.push_back({name, text_of(value), "true, false", "",
                           [name, &value](const ParameterValue& given) { value = flag_in(name, given); }});
  }

  template <class Number>
  void operator()(std::string_view key, Number& value, double least, double greatest, const char* unit = "")
  {
    const std::string name = prefix_ + std::string(key);
    const OptionRange range{least, greatest, unit, std::is_integral_v<Number>};
    parameters_.push_back({name, to_text(static_cast<double>(value)), limits_of(range), unit,
                           [name, &value, range](const ParameterValue& given) {
                             value = static_cast<Number>(number_in(name, given, range));
                           }});
  }

  /// `otherwise` says what it is where it is not set.
  void operator()(std::string_view key, std::optional<double>& value, double least, double greatest, const char* unit,
                  const char* otherwise)
  {
    const std::string name = prefix_ + std::string(key);
    const OptionRange range{least, greatest, unit};
    parameters_.push_back(
        {name, value ? to_text(*value) : otherwise, limits_of(range), unit,
         [name, &value, range](const ParameterValue& given) { value = number_in(name, given, range); }, true});
  }

  template <class Value, class Text>
  void operator()(std::string_view key, Value& value, const Text& text)
  {
    const std::string name = prefix_ + std::string(key);
    parameters_.push_back(
        {name, text.write(value), text.expected(), "", [name, &value, text](const ParameterValue& given) {
           const std::string* word = std::get_if<std::string>(&given);
           if (!word || !text.read(*word, value)) reject_option(name, text_of(given), text.expected());
         }});
  }

  template <class... Member>
  void fixed(std::string_view, const Member&...)
  {}

  template <class Nested>
  void group(const std::string& prefix, Nested& nested)
  {
    const std::string outer = std::exchange(prefix_, prefix_ + prefix);
    Nested::describe(nested, *this);
    prefix_ = outer;
  }

private:
  std::string prefix_;
  std::vector<Parameter> parameters_;
};

/// Sets each member from the key of its name; one without a key stays as it is. Throws ConfigError for an unknown key, and for
/// a value that is none of what it may be. `others` are known as well, for the text of the error.
void set_from(const ParameterMap& given, const std::vector<Parameter>& parameters,
              const std::vector<std::string>& others = {});

/// A sentence with the keys that are not given and the values that they keep; empty when all are given.
std::string defaults_taken(const ParameterMap& given, const std::vector<Parameter>& parameters);

/// The defaults, and what is given of them.
template <class Options>
Options options_from(const ParameterMap& given)
{
  Options options;
  set_from(given, ParameterList::of(options));
  return options;
}

/// The same for the keys of a struct of options.
template <class Options>
std::string defaults_taken(const ParameterMap& given)
{
  Options defaults;
  return defaults_taken(given, ParameterList::of(defaults));
}

/// Throws what check(options) does as ConfigError.
template <class Options>
void check_configuration(const Options& options)
{
  try
  {
    check(options);
  }
  catch (const std::invalid_argument& error)
  {
    throw ConfigError(error.what());
  }
}

}  // namespace fourwis
