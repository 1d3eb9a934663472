#pragma once

#include <string>

#include <gtest/gtest.h>
#include <ros/ros.h>

namespace fourwis
{

/// For the main of a rostest: callbacks run beside the tests.
inline int run_rostest(int argc, char** argv, const std::string& name)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, name);
  const ros::NodeHandle node;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}

}  // namespace fourwis
