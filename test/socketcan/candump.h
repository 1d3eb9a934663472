#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace fourwis::can
{

/// candump of can-utils, which watches vcan0 for error frames as well.
class Candump
{
public:
  /// Returns when it listens. It stops after `frames` frames, or 20 s without any.
  explicit Candump(int frames)
  {
    const std::ptrdiff_t before = listeners();
    const std::string count = std::to_string(frames);
    pipe_ = popen(("exec candump -L -n " + count + " -T 20000 vcan0,0:0,#FFFFFFFF 2>&1").c_str(), "r");
    while (pipe_ != nullptr && listeners() == before && std::feof(pipe_) == 0) continue;
  }
  ~Candump()
  {
    if (pipe_ != nullptr) pclose(pipe_);
  }
  Candump(const Candump&) = delete;
  Candump& operator=(const Candump&) = delete;

  /// What it has seen when it stops, without times and interface: ID#DATA.
  std::vector<std::string> frames()
  {
    std::vector<std::string> seen;
    char line[128];
    while (std::fgets(line, sizeof line, pipe_) != nullptr)
    {
      const std::string text = line;
      const std::size_t begin = text.find(" vcan0 ");
      EXPECT_NE(begin, std::string::npos) << text;
      if (begin != std::string::npos) seen.push_back(text.substr(begin + 7, text.size() - begin - 8));
    }
    return seen;
  }

private:
  /// Who listens to all frames of the machine's interfaces.
  static std::ptrdiff_t listeners()
  {
    std::ifstream list("/proc/net/can/rcvlist_all");
    return std::count(std::istreambuf_iterator<char>(list), {}, '\n');
  }

  std::FILE* pipe_;
};

}  // namespace fourwis::can
