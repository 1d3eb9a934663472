#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "fourwis_navigation/model/option_range.h"

namespace fourwis
{

// A struct of options has one table that names each of its members once, a function template beside the members:
//
//   template <class Self, class Row>
//   static void describe(Self& o, Row& row)
//   {
//     row("speed", o.speed, 0.01, 20.0, "m/s");           // a number: key, member, least, greatest, unit
//     row("step", o.step, 0.1, 5.0, "m", "half the length");  // a std::optional<double>, and what it is where it is not set
//     row("knots", o.knots, 2, 200);                      // whole, as the member is
//     row("connect", o.connect);                          // true or false
//     row("solver", o.solver, OneOf{"fast", "exact"});    // a text (option_text.h)
//     row.fixed("epsilon", o.epsilon, 0.0, 1.0, "m");     // checked, but no key of a configuration
//     row.group("left/", o.left);                         // a struct of options, its keys after this prefix
//   }
//
// The same table is read by check(), by the configuration files (src/parameters/parameter_list.h) and by
// doc/parameters.md. check() beside the struct begins with check_ranges(), and what takes the struct calls check().

/// A reader of such a table that throws std::invalid_argument at the first member that is none of what it may be, naming
/// key, value and what was expected.
class OptionCheck
{
public:
  explicit OptionCheck(std::string prefix = {}) : prefix_(std::move(prefix)) {}

  void operator()(std::string_view, bool) const {}

  template <class Number>
  void operator()(std::string_view key, Number value, double least, double greatest, const char* unit = "") const
  {
    const OptionRange range{least, greatest, unit, std::is_integral_v<Number>};
    const double number = static_cast<double>(value);
    if (!range.contains(number)) require_in(range, name_of(key), number);
  }

  void operator()(std::string_view key, const std::optional<double>& value, double least, double greatest,
                  const char* unit, const char*) const
  {
    if (value) (*this)(key, *value, least, greatest, unit);
  }

  template <class Value, class Text>
  void operator()(std::string_view key, const Value& value, const Text& text) const
  {
    const std::string written = text.write(value);
    Value read = value;
    if (!text.read(written, read)) reject_option(name_of(key), '\'' + written + '\'', text.expected());
  }

  template <class... Member>
  void fixed(std::string_view key, const Member&... member) const
  {
    (*this)(key, member...);
  }

  template <class Nested>
  void group(const std::string& prefix, const Nested& nested) const
  {
    const OptionCheck row(prefix_ + prefix);
    Nested::describe(nested, row);
  }

private:
  std::string name_of(std::string_view key) const { return prefix_ + std::string(key); }

  std::string prefix_;
};

template <class Options>
void check_ranges(const Options& options)
{
  const OptionCheck row;
  Options::describe(options, row);
}

/// The options themselves, for lists of initialisers. Throws as their check() does.
template <class Options>
const Options& checked(const Options& options)
{
  check(options);
  return options;
}

}  // namespace fourwis
