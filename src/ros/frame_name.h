#pragma once

#include <string>

namespace fourwis
{

/// The name of a frame as tf2 knows it, without the leading slash that older tools still write.
inline std::string without_slash(const std::string& frame)
{
  return frame.compare(0, 1, "/") == 0 ? frame.substr(1) : frame;
}

}  // namespace fourwis
