#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace fourwis::can
{

/// Runs a shell command that has to succeed.
inline void run(const std::string& command)
{
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

}  // namespace fourwis::can
