#pragma once

#include <string>

namespace fourwis
{

/// doc/parameters.md: key, default, range and unit of every parameter.
std::string parameter_documentation();

}  // namespace fourwis
