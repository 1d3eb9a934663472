#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "../can/bus/temporary_directory.h"
#include "command.h"

namespace fourwis::can
{

/// candump of can-utils on an interface, with error frames.
class Candump
{
public:
  /// Returns when candump listens.
  explicit Candump(const std::string& interface = "vcan0") : interface_(interface)
  {
    const std::ptrdiff_t before = listeners();
    process_ = fork();
    if (process_ == 0) become_candump();
    while (listeners() == before && is_alive()) continue;
  }
  ~Candump() { end(); }
  Candump(const Candump&) = delete;
  Candump& operator=(const Candump&) = delete;

  /// All frames that candump has seen, as ID#DATA. Ends candump.
  std::vector<std::string> frames()
  {
    const std::string last = "1FFFFFFE#";
    run("cansend " + interface_ + ' ' + last);
    std::vector<std::string> seen = lines();
    while ((seen.empty() || seen.back() != last) && is_alive()) seen = lines();
    end();
    EXPECT_TRUE(!seen.empty() && seen.back() == last) << "candump died";
    if (!seen.empty()) seen.pop_back();
    return seen;
  }

private:
  std::string file() const { return directory_.path() + "/frames"; }

  [[noreturn]] void become_candump() const
  {
    const int output = open(file().c_str(), O_CREAT | O_WRONLY, 0600);
    dup2(output, STDOUT_FILENO);
    execlp("candump", "candump", "-L", "-D", "-r", "4194304", (interface_ + ",0:0,#FFFFFFFF").c_str(), nullptr);
    _exit(127);
  }

  /// Who listens to all frames of the machine's interfaces.
  static std::ptrdiff_t listeners()
  {
    std::ifstream list("/proc/net/can/rcvlist_all");
    return std::count(std::istreambuf_iterator<char>(list), {}, '\n');
  }

  /// What has been written so far, in whole lines "(time) interface ID#DATA".
  std::vector<std::string> lines() const
  {
    std::vector<std::string> seen;
    std::ifstream output(file());
    for (std::string line; std::getline(output, line) && !output.eof();)
      seen.push_back(line.substr(line.find_last_of(' ') + 1));
    return seen;
  }

  bool is_alive()
  {
    if (process_ > 0 && waitpid(process_, nullptr, WNOHANG) != 0) process_ = -1;
    return process_ > 0;
  }

  void end()
  {
    if (!is_alive()) return;
    kill(process_, SIGINT);
    waitpid(process_, nullptr, 0);
    process_ = -1;
  }

  TemporaryDirectory directory_;
  std::string interface_;
  pid_t process_ = -1;
};

}  // namespace fourwis::can
