#pragma once

#include <cstddef>
#include <cstdio>
#include <sstream>
#include <string>

namespace fourwis
{

/// The sentences in which the package explains itself: printf into a string of any length.
template <class... Values>
std::string sentence(const char* format, Values... values)
{
  const int length = std::snprintf(nullptr, 0, format, values...);
  if (length <= 0) return {};
  std::string text(static_cast<std::size_t>(length), '\0');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

/// The same of parts that a stream can write, one after the other.
template <class... Parts>
std::string joined(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// Throws Error with the parts as its text. It is for input and configuration that cannot be used (doc/design.md, "How the
/// package says no").
template <class Error, class... Parts>
[[noreturn]] void reject(const Parts&... parts)
{
  throw Error(joined(parts...));
}

}  // namespace fourwis
