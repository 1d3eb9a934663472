#pragma once

#include <array>
#include <cstdio>

namespace fourwis
{

/// Why the robot has to stop, or nothing. It is a format of std::printf with up to two numbers, because the control step
/// must not allocate. A number for which the format has no place is left out.
struct StopReason
{
  const char* format = nullptr;  ///< of static storage
  double first = 0.0, second = 0.0;

  explicit operator bool() const { return format != nullptr; }
};

/// A sentence in a fixed buffer.
using Sentence = std::array<char, 200>;

/// Writes the sentence of `reason`; an empty one if there is no reason.
inline void write(const StopReason& reason, Sentence& sentence)
{
  sentence[0] = '\0';
  if (reason) std::snprintf(sentence.data(), sentence.size(), reason.format, reason.first, reason.second);
}

}  // namespace fourwis
