#include "node_parameters.h"

#include <cmath>
#include <sstream>

#include "conversions.h"

namespace fourwis
{
namespace
{

using XmlRpc::XmlRpcValue;

std::string text_of(const ParameterValue& value)
{
  std::ostringstream text;
  text << std::boolalpha;
  if (const std::string* word = std::get_if<std::string>(&value))
    text << '\'' << *word << '\'';
  else
    std::visit([&text](const auto& plain) { text << plain; }, value);
  return text.str();
}

[[noreturn]] void refuse(const std::string& key, const ParameterValue& value, const std::string& expected)
{
  throw ConfigError("parameter '" + key + "' is " + text_of(value) + ", expected " + expected);
}

void flatten(const std::string& key, const XmlRpcValue& value, ParameterMap& parameters)
{
  switch (value.getType())
  {
    case XmlRpcValue::TypeBoolean: parameters[key] = static_cast<const bool&>(value); return;
    case XmlRpcValue::TypeInt: parameters[key] = static_cast<double>(static_cast<const int&>(value)); return;
    case XmlRpcValue::TypeDouble: parameters[key] = static_cast<const double&>(value); return;
    case XmlRpcValue::TypeString: parameters[key] = static_cast<const std::string&>(value); return;
    case XmlRpcValue::TypeStruct:
      for (const auto& [name, member] : value) flatten(key.empty() ? name : key + '/' + name, member, parameters);
      return;
    default:
      throw ConfigError("parameter '" + key + "' is " + value.toXml() + ", expected a number, true, false or a text");
  }
}

std::vector<std::string> words_of(const std::string& list)
{
  std::vector<std::string> words;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

StartFrom start_from(const std::string& name)
{
  if (name == "tf") return StartFrom::tf;
  if (name == "initialpose") return StartFrom::initial_pose;
  refuse("start_from", name, "'tf' or 'initialpose'");
}

ModeSet modes(const std::string& list)
{
  const std::vector<std::string> names = words_of(list);
  try
  {
    if (!names.empty()) return to_modes(names);
  }
  catch (const ConversionError&)
  {}
  refuse("modes", list, "names out of " + planned_mode_names(", ", " and ") + " with commas between them");
}

GlobalPlannerOptions options_from(KeyReader& reader)
{
  GlobalPlannerOptions options;
  options.global_frame = reader.frame("global_frame");
  options.robot_base_frame = reader.frame("robot_base_frame");
  options.transform_tolerance = reader.number("transform_tolerance", 0.01, 60.0, "s");
  options.start_from = start_from(reader.text("start_from"));
  options.modes = modes(reader.text("modes"));
  options.wait_for_controller = reader.flag("wait_for_controller");
  options.controller_patience = reader.number("controller_patience", 0.1, 60.0, "s");
  options.replan_attempts = reader.count("replan_attempts", 0, 100, "attempts");
  options.start_delay = reader.number("start_delay", 0.0, 10.0, "s");
  options.stop_delay = reader.number("stop_delay", 0.0, 0.5, "s");
  options.show_expansions = reader.flag("show_expansions");
  options.show_corridors = reader.flag("show_corridors");
  options.show_iterations = reader.flag("show_iterations");
  return options;
}

}  // namespace

ParameterMap to_parameters(const XmlRpcValue& value)
{
  ParameterMap parameters;
  if (value.valid()) flatten("", value, parameters);
  return parameters;
}

ParameterMap read_parameters(const ros::NodeHandle& node)
{
  XmlRpcValue value;
  node.getParam(node.getNamespace(), value);
  return to_parameters(value);
}

std::string KeyReader::text(const std::string& key)
{
  const ParameterValue value = take(key);
  if (!std::holds_alternative<std::string>(value)) refuse(key, value, "a text");
  return std::get<std::string>(value);
}

std::string KeyReader::text(const std::string& key, const std::string& fallback)
{
  if (has(key)) return text(key);
  known_.push_back(key);
  return fallback;
}

double KeyReader::number(const std::string& key, double min, double max, const std::string& unit)
{
  const ParameterValue value = take(key);
  const double* number = std::get_if<double>(&value);
  std::ostringstream expected;
  expected << "a number from " << min << " to " << max << ' ' << unit;
  // Written so that NaN, too, is refused.
  if (!number || !(*number >= min && *number <= max)) refuse(key, value, expected.str());
  return *number;
}

double KeyReader::number(const std::string& key, double min, double max, const std::string& unit, double fallback)
{
  if (has(key)) return number(key, min, max, unit);
  known_.push_back(key);
  return fallback;
}

int KeyReader::count(const std::string& key, int min, int max, const std::string& unit)
{
  const double value = number(key, min, max, unit);
  if (value != std::floor(value)) refuse(key, value, "a whole number of " + unit);
  return static_cast<int>(value);
}

bool KeyReader::flag(const std::string& key)
{
  const ParameterValue value = take(key);
  if (!std::holds_alternative<bool>(value)) refuse(key, value, "true or false");
  return std::get<bool>(value);
}

std::string KeyReader::frame(const std::string& key)
{
  const std::string name = text(key);
  if (name.empty() || name.front() == '/') refuse(key, name, "the name of a tf frame, without a leading slash");
  return name;
}

ParameterMap KeyReader::take_group(const std::string& name)
{
  known_.push_back(name + "/...");
  const std::string prefix = name + '/';
  ParameterMap members;
  for (auto it = parameters_.lower_bound(prefix); it != parameters_.end() && it->first.rfind(prefix, 0) == 0;)
  {
    members[it->first.substr(prefix.size())] = it->second;
    it = parameters_.erase(it);
  }
  return members;
}

void KeyReader::ignore(const std::vector<std::string>& keys)
{
  for (const std::string& key : keys) parameters_.erase(key);
}

void KeyReader::finish() const
{
  if (parameters_.empty()) return;
  const auto& [key, value] = *parameters_.begin();
  std::string expected;
  for (const std::string& name : known_) expected += (expected.empty() ? "" : ", ") + name;
  throw ConfigError("unknown parameter '" + key + "' (" + text_of(value) + "), expected only: " + expected);
}

ParameterValue KeyReader::take(const std::string& key)
{
  known_.push_back(key);
  const auto found = parameters_.find(key);
  if (found == parameters_.end()) throw ConfigError("missing parameter '" + key + "'");
  ParameterValue value = std::move(found->second);
  parameters_.erase(found);
  return value;
}

GlobalPlannerParameters global_planner_parameters_from(const ParameterMap& parameters)
{
  KeyReader reader(parameters);
  GlobalPlannerParameters result;
  result.node = options_from(reader);
  result.robot = reader.group("robot", robot_from);
  result.planner = reader.group("planner", planner_options_from);
  // Read by diagnostic_updater and actionlib, which share the namespace of a node that is named after its action.
  reader.ignore({"diagnostic_period", "status_frequency", "status_list_timeout", "actionlib_status_frequency",
                 "actionlib_server_pub_queue_size", "actionlib_server_sub_queue_size"});
  reader.finish();
  return result;
}

}  // namespace fourwis
