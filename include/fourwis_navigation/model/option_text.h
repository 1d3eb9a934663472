#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace fourwis
{

// How options that are no numbers are written. expected() ends the sentence "parameter ... is ..., expected"; read() sets
// the value, or returns false where the text is none of what is expected; write() is its inverse.

/// Any text but an empty one.
struct Word
{
  std::string expected() const { return "a word"; }
  std::string write(const std::string& value) const { return value; }
  bool read(const std::string& text, std::string& value) const
  {
    value = text;
    return !text.empty();
  }
};

/// The words of an enumeration, whose values count from 0 in their order.
template <std::size_t N>
struct OneOf
{
  std::array<const char*, N> words;

  std::string expected() const
  {
    std::string list = "one of ";
    for (std::size_t i = 0; i < N; ++i) list += (i > 0 ? std::string(", ") : std::string()) + words[i];
    return list;
  }
  /// Empty for a value that has no word.
  template <class Enum>
  std::string write(Enum value) const
  {
    const auto i = static_cast<std::size_t>(value);
    return i < N ? words[i] : "";
  }
  template <class Enum>
  bool read(const std::string& text, Enum& value) const
  {
    for (std::size_t i = 0; i < N; ++i)
      if (text == words[i])
      {
        value = static_cast<Enum>(i);
        return true;
      }
    return false;
  }
};

template <class... Words>
OneOf(Words...) -> OneOf<sizeof...(Words)>;

}  // namespace fourwis
