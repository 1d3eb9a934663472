#pragma once

#include <array>
#include <cstdio>

namespace fourwis
{

/// Why the robot has to stop: a sentence with up to two numbers in it, as std::printf has them, or nothing. A number
/// without a place in the sentence is left out.
struct Trouble
{
  const char* format = nullptr;  ///< of static storage
  double first = 0.0, second = 0.0;

  explicit operator bool() const { return format != nullptr; }
};

/// The sentence of a trouble, or an empty one.
using Sentence = std::array<char, 200>;

inline void write(const Trouble& trouble, Sentence& sentence)
{
  sentence[0] = '\0';
  if (trouble) std::snprintf(sentence.data(), sentence.size(), trouble.format, trouble.first, trouble.second);
}

}  // namespace fourwis
