#pragma once

#include <exception>
#include <string>
#include <vector>

#include <ros/ros.h>

namespace fourwis
{

/// Runs a node; what ends it with an exception is said in one line, on the console and in the log. Returns the exit
/// status of the process: 0, or 2 for unusable configuration or input.
template <class Run>
int node_main(Run run)
{
  const ros::NodeHandle alive;  // with the last handle ROS shuts down, and its console with it
  try
  {
    run();
    return 0;
  }
  catch (const std::exception& error)
  {
    ROS_FATAL("%s", error.what());
    return 2;
  }
}

/// Says on the console and in the log what a person should know, and what stops nothing.
inline void warn(const std::vector<std::string>& notes)
{
  for (const std::string& note : notes) ROS_WARN("%s", note.c_str());
}

}  // namespace fourwis
