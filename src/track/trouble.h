#pragma once

namespace fourwis
{

/// Why the robot has to stop: a sentence with up to two numbers in it, as std::printf has them, or nothing.
struct Trouble
{
  const char* format = nullptr;  ///< of static storage
  double first = 0.0, second = 0.0;

  explicit operator bool() const { return format != nullptr; }
};

}  // namespace fourwis
