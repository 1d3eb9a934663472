#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "fourwis_navigation/model/option_range.h"

namespace fourwis
{

/// A reader of a table of options (model/option_check.h) that hashes keys and values: FNV-1a of 64 bits.
class Fingerprint
{
public:
  void operator()(std::string_view key, bool value) { add(key, value ? "true" : "false"); }

  template <class Number>
  void operator()(std::string_view key, Number value, double, double, const char* = "")
  {
    add(key, to_text(static_cast<double>(value) + 0.0));  // -0 is the same as 0
  }

  void operator()(std::string_view key, const std::optional<double>& value, double least, double greatest,
                  const char* unit, const char* otherwise)
  {
    if (value) return (*this)(key, *value, least, greatest, unit);
    add(key, otherwise);
  }

  template <class Value, class Text>
  void operator()(std::string_view key, const Value& value, const Text& text)
  {
    add(key, text.write(value));
  }

  template <class... Member>
  void fixed(std::string_view, const Member&...)
  {}

  template <class Nested>
  void group(const std::string& prefix, const Nested& nested)
  {
    add(prefix, "");
    Nested::describe(nested, *this);
  }

  /// 16 hexadecimal digits.
  std::string text() const;

private:
  void add(std::string_view key, std::string_view value);

  std::uint64_t hash_ = 0xcbf29ce484222325;
};

/// Tells options apart whose keys or values differ: 16 hexadecimal digits, the same on every machine.
template <class Options>
std::string fingerprint(const Options& options)
{
  Fingerprint row;
  Options::describe(options, row);
  return row.text();
}

}  // namespace fourwis
