#pragma once

#include <string>

#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{

/// What roslaunch and rosparam make of a scalar of a YAML file, so that a file means the same without them: YAML 1.1 as PyYAML
/// reads it, and rosparam's angles. `tag` is the scalar's as yaml-cpp has it. Throws std::invalid_argument naming the key.
ParameterValue yaml_value(const std::string& key, const std::string& tag, const std::string& text);

}  // namespace fourwis
