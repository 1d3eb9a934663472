#pragma once

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fourwis
{

/// A node of this project as a process of its own; killed when this goes.
class NodeProcess
{
public:
  NodeProcess(const std::string& executable, const std::vector<std::string>& arguments)
  {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe2 failed");
    std::string path = FOURWIS_NODE_DIR "/" + executable;
    std::vector<std::string> words = arguments;
    std::vector<char*> argv = {path.data()};
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    process_ = fork();
    if (process_ == 0)
    {
      dup2(ends[1], STDOUT_FILENO);
      dup2(ends[1], STDERR_FILENO);
      execv(path.c_str(), argv.data());
      _exit(127);
    }
    close(ends[1]);
    output_ = ends[0];
  }
  ~NodeProcess()
  {
    close(output_);
    if (process_ > 0 && !ended_)
    {
      kill(process_, SIGTERM);
      waitpid(process_, nullptr, 0);
    }
  }
  NodeProcess(const NodeProcess&) = delete;
  NodeProcess& operator=(const NodeProcess&) = delete;

  /// Waits for it to end by itself; everything it wrote.
  std::string read_to_end()
  {
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t count = 0; (count = read(output_, buffer.data(), buffer.size())) > 0;)
      text.append(buffer.data(), static_cast<std::size_t>(count));
    return text;
  }

  /// Asks it to end.
  void terminate() { kill(process_, SIGTERM); }

  /// Ends it as a crash does.
  void crash() { kill(process_, SIGKILL); }

  /// Stops it as a machine that swaps does, and lets it go on.
  void freeze() { kill(process_, SIGSTOP); }
  void thaw() { kill(process_, SIGCONT); }

  /// Its threads.
  std::vector<pid_t> threads() const
  {
    std::vector<pid_t> found;
    const std::string folder = "/proc/" + std::to_string(process_) + "/task";
    DIR* entries = opendir(folder.c_str());
    if (!entries) throw std::runtime_error(folder + " cannot be read");
    while (const dirent* entry = readdir(entries))
      if (entry->d_name[0] != '.') found.push_back(static_cast<pid_t>(std::stol(entry->d_name)));
    closedir(entries);
    return found;
  }

  /// Stops one of its threads, and lets it go on. Both from the same thread of the caller.
  static bool freeze_thread(pid_t thread)
  {
    if (ptrace(PTRACE_SEIZE, thread, nullptr, nullptr) != 0) return false;
    if (ptrace(PTRACE_INTERRUPT, thread, nullptr, nullptr) != 0) return false;
    return waitpid(thread, nullptr, __WALL) == thread;
  }
  static void thaw_thread(pid_t thread) { ptrace(PTRACE_DETACH, thread, nullptr, nullptr); }

  /// Waits for it to end by itself; its exit status, -1 when a signal ended it.
  int exit_status()
  {
    int status = 0;
    waitpid(process_, &status, 0);
    ended_ = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

private:
  pid_t process_ = -1;
  int output_ = -1;
  bool ended_ = false;
};

}  // namespace fourwis
