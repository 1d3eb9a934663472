#pragma once

#include <cstdlib>
#include <string>

namespace fourwis
{

/// A path as a person writes it: "~" and "~/..." lie in $HOME, as in a shell, which does not see what stands in files, on the
/// parameter server or behind "map:=". All else, and all where there is no $HOME, stays as it is.
inline std::string expand_home(const std::string& path)
{
  const bool is_in_home = path == "~" || path.compare(0, 2, "~/") == 0;
  const char* home = is_in_home ? std::getenv("HOME") : nullptr;
  return home && *home != '\0' ? home + path.substr(1) : path;
}

}  // namespace fourwis
