#include "parameter_server.h"

#include <string>

#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{
namespace
{

using XmlRpc::XmlRpcValue;

void flatten(const std::string& key, const XmlRpcValue& value, ParameterMap& parameters)
{
  switch (value.getType())
  {
    case XmlRpcValue::TypeBoolean: parameters[key] = static_cast<const bool&>(value); return;
    case XmlRpcValue::TypeInt: parameters[key] = static_cast<double>(static_cast<const int&>(value)); return;
    case XmlRpcValue::TypeDouble: parameters[key] = static_cast<const double&>(value); return;
    case XmlRpcValue::TypeString: parameters[key] = static_cast<const std::string&>(value); return;
    case XmlRpcValue::TypeStruct:
      for (const auto& [name, member] : value) flatten(key.empty() ? name : joined(key, '/', name), member, parameters);
      return;
    default:
      throw ConfigError("parameter '" + key + "' is " + value.toXml() + ", expected a number, true, false or a text");
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
