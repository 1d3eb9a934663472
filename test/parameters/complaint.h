#pragma once

#include <string>

#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{

/// What `read` says against `parameters`; empty when it accepts them.
template <class Options>
std::string complaint(Options (*read)(const ParameterMap&), const ParameterMap& parameters)
{
  try
  {
    read(parameters);
  }
  catch (const ConfigError& error)
  {
    return error.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

}  // namespace fourwis
