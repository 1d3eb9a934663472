#pragma once

#include <unistd.h>

#include <utility>

namespace fourwis::can
{

/// Owns a file descriptor of the operating system; -1 for none.
class FileDescriptor
{
public:
  explicit FileDescriptor(int fd = -1) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept
  {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~FileDescriptor()
  {
    if (fd_ >= 0) close(fd_);
  }

  int get() const { return fd_; }
  explicit operator bool() const { return fd_ >= 0; }
  void reset() { FileDescriptor none(std::exchange(fd_, -1)); }

private:
  int fd_;
};

}  // namespace fourwis::can
