#include "parameter_server.h"

#include <string>

#include "fourwis_navigation/model/option_range.h"
#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{
namespace
{

using XmlRpc::XmlRpcValue;

/// A list of numbers or of such lists as the text that it is written as, as parameter files have it: "[[1, 2], [3, 4]]".
std::string list_text(const std::string& key, const XmlRpcValue& list)
{
  std::string text;
  for (int i = 0; i < list.size(); ++i)
  {
    const XmlRpcValue& member = list[i];
    text += i > 0 ? ", " : "";
    switch (member.getType())
    {
      case XmlRpcValue::TypeArray: text += list_text(key, member); break;
      case XmlRpcValue::TypeInt: text += to_text(static_cast<const int&>(member)); break;
      case XmlRpcValue::TypeDouble: text += to_text(static_cast<const double&>(member)); break;
      case XmlRpcValue::TypeString: text += static_cast<const std::string&>(member); break;
      default: throw ConfigError("parameter '" + key + "' has " + member.toXml() + " in its list, expected a number");
    }
  }
  return '[' + text + ']';
}

void flatten(const std::string& key, const XmlRpcValue& value, ParameterMap& parameters)
{
  switch (value.getType())
  {
    case XmlRpcValue::TypeBoolean: parameters[key] = static_cast<const bool&>(value); return;
    case XmlRpcValue::TypeInt: parameters[key] = static_cast<double>(static_cast<const int&>(value)); return;
    case XmlRpcValue::TypeDouble: parameters[key] = static_cast<const double&>(value); return;
    case XmlRpcValue::TypeString: parameters[key] = static_cast<const std::string&>(value); return;
    case XmlRpcValue::TypeArray: parameters[key] = list_text(key, value); return;
    case XmlRpcValue::TypeStruct:
      for (const auto& [name, member] : value) flatten(key.empty() ? name : joined(key, '/', name), member, parameters);
      return;
    default:
      throw ConfigError("parameter '" + key + "' is " + value.toXml() +
                        ", expected a number, true, false, a text or a list");
  }
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

}  // namespace fourwis
