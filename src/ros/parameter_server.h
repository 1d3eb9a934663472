#pragma once

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{

/// Flattens a struct of the parameter server; numbers become double. Throws ConfigError, naming the key, for what has
/// no place in a ParameterMap: lists, dates, binary data.
ParameterMap to_parameters(const XmlRpc::XmlRpcValue& value);

/// Everything under the handle's namespace.
ParameterMap read_parameters(const ros::NodeHandle& node);

}  // namespace fourwis
