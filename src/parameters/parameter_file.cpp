#include <fstream>
#include <ios>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>

#include <yaml-cpp/yaml.h>

#include "fourwis_navigation/model/home_path.h"
#include "fourwis_navigation/parameters/parameters.h"
#include "parameter_list.h"
#include "yaml_value.h"

namespace fourwis
{
namespace
{

/// Anchors allow a YAML map to contain itself; no configuration of ours is nested deeper.
constexpr int kMaxDepth = 8;

[[noreturn]] void reject_at(const std::string& path, const YAML::Mark& mark, const std::string& what)
{
  const std::string line = mark.is_null() ? "" : ":" + std::to_string(mark.line + 1);
  throw ConfigError(path + line + ": " + what);
}

ParameterValue value_of(const std::string& path, const std::string& key, const YAML::Node& scalar)
{
  try
  {
    return yaml_value(key, scalar.Tag(), scalar.Scalar());
  }
  catch (const std::invalid_argument& error)
  {
    reject_at(path, scalar.Mark(), error.what());
  }
}

/// A list of numbers or of such lists as the text that it is written as: "[[1, 2], [3, 4]]".
std::string list_text(const std::string& path, const std::string& key, const YAML::Node& node, int depth)
{
  if (depth > kMaxDepth)
    reject_at(path, node.Mark(), "lists nested deeper than " + std::to_string(kMaxDepth) + " levels");
  if (node.IsScalar())
  {
    const ParameterValue value = value_of(path, key, node);
    const std::optional<double> number = plain_number(value);
    if (!number)
      reject_at(path, node.Mark(), "parameter '" + key + "' has " + text_of(value) + " in its list, expected a number");
    return to_text(*number + 0.0);  // -0 is the same as 0
  }
  if (!node.IsSequence())
    reject_at(path, node.Mark(), "parameter '" + key + "' holds no list of numbers, expected one");
  std::string text;
  for (const YAML::Node& member : node) text += (text.empty() ? "" : ", ") + list_text(path, key, member, depth + 1);
  return '[' + text + ']';
}

void flatten(const std::string& path, const std::string& prefix, const YAML::Node& map, int depth, ParameterMap& out)
{
  if (depth > kMaxDepth)
    reject_at(path, map.Mark(), "maps nested deeper than " + std::to_string(kMaxDepth) + " levels");
  for (const auto& entry : map)
  {
    if (!entry.first.IsScalar()) reject_at(path, entry.first.Mark(), "a key must be a plain word");
    const std::string key = prefix + entry.first.Scalar();
    if (entry.second.IsMap())
    {
      flatten(path, key + "/", entry.second, depth + 1, out);
      continue;
    }
    if (entry.second.IsNull())
      reject_at(path, entry.first.Mark(), "parameter '" + key + "' has no value, expected a number, a word or a list");
    const bool is_list = entry.second.IsSequence();
    if (!out.emplace(key, is_list ? ParameterValue(list_text(path, key, entry.second, depth))
                                  : value_of(path, key, entry.second))
             .second)
      reject_at(path, entry.first.Mark(), "parameter '" + key + "' appears twice, expected once");
  }
}

std::string content_of(const std::string& path)
{
  const std::string expected = path + ": cannot be read, expected a YAML file";
  std::ifstream file(expand_home(path));
  if (!file) throw ConfigError(expected);
  try
  {
    return {std::istreambuf_iterator<char>(file), {}};
  }
  catch (const std::ios_base::failure&)  // a directory
  {
    throw ConfigError(expected);
  }
}

YAML::Node load(const std::string& path)
{
  const std::string text = content_of(path);
  try
  {
    return YAML::Load(text);
  }
  catch (const YAML::Exception& error)
  {
    reject_at(path, error.mark, "not YAML: " + error.msg);
  }
}

template <class Options>
Options from_file(const std::string& path, Options (*convert)(const ParameterMap&), std::string* defaults)
{
  const ParameterMap parameters = read_parameter_file(path);
  try
  {
    Options options = convert(parameters);
    check_configuration(options);  // what its keys say of each other
    const std::string taken = defaults_taken<Options>(parameters);
    if (defaults && !taken.empty()) *defaults = path + ": " + taken;
    return options;
  }
  catch (const ConfigError& error)
  {
    throw ConfigError(path + ": " + error.what());
  }
}

}  // namespace

ParameterMap read_parameter_file(const std::string& path)
{
  const YAML::Node root = load(path);
  if (!root.IsMap()) throw ConfigError(path + ": holds no parameters, expected lines of the form 'key: value'");
  ParameterMap parameters;
  flatten(path, "", root, 1, parameters);
  return parameters;
}

Robot read_robot_file(const std::string& path, std::string* defaults)
{
  return from_file(path, robot_from, defaults);
}

PlannerOptions read_planner_file(const std::string& path, std::string* defaults)
{
  return from_file(path, planner_options_from, defaults);
}

TrackOptions read_track_file(const std::string& path, std::string* defaults)
{
  return from_file(path, track_options_from, defaults);
}

SimulatorOptions read_simulator_file(const std::string& path, std::string* defaults)
{
  return from_file(path, simulator_options_from, defaults);
}

can::BridgeOptions read_bridge_file(const std::string& path, std::string* defaults)
{
  return from_file(path, bridge_options_from, defaults);
}

}  // namespace fourwis
