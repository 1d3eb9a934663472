#pragma once

#include <exception>

#include <ros/ros.h>

namespace fourwis
{

/// Runs a node; what ends it with an exception is said in one line, on the console and in the log. Returns the exit
/// status of the process: 0, or 2 for unusable configuration or input.
template <class Run>
int node_main(Run run)
{
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

}  // namespace fourwis
