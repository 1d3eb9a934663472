#include "forked.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>

namespace fourwis::nightly
{
namespace
{

bool write_all(int file, const void* data, std::size_t size)
{
  const char* at = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t written = write(file, at, size);
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

bool read_all(int file, void* data, std::size_t size)
{
  char* at = static_cast<char*>(data);
  while (size > 0)
  {
    const ssize_t got = read(file, at, size);
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

/// The child's life. It must not run what the parent has to do at its end.
[[noreturn]] void live(int pipe, std::size_t first, std::size_t count,
                       const std::function<std::string(std::size_t)>& work)
{
  // Who stops the program may tell all its processes: that is no crash. The batch is short, the parent stops behind it.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  try
  {
    for (std::size_t k = first; k < count; ++k)
    {
      const std::string text = work(k);
      const std::uint64_t size = text.size();
      if (!write_all(pipe, &size, sizeof size) || !write_all(pipe, text.data(), text.size())) _exit(1);
    }
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "nightly_figures: a child threw: %s\n", error.what());
    _exit(1);
  }
  _exit(0);
}

}  // namespace

void in_child(std::size_t count, const std::function<std::string(std::size_t)>& work,
              const std::function<void(std::size_t, const std::string&)>& done,
              const std::function<void(std::size_t)>& crashed)
{
  for (std::size_t next = 0; next < count;)
  {
    int ends[2];
    std::cout.flush();
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no child process");
    if (child == 0)
    {
      close(ends[0]);
      live(ends[1], next, count, work);
    }
    close(ends[1]);
    std::uint64_t size = 0;
    while (next < count && read_all(ends[0], &size, sizeof size))
    {
      std::string text(size, ' ');
      if (!read_all(ends[0], text.data(), text.size())) break;
      done(next++, text);
    }
    close(ends[0]);
    waitpid(child, nullptr, 0);
    if (next < count) crashed(next++);
  }
}

}  // namespace fourwis::nightly
