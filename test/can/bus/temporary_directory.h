#pragma once

#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace fourwis::can
{

/// A private directory that is removed at the end.
class TemporaryDirectory
{
public:
  TemporaryDirectory()
  {
    char name[] = "/tmp/fourwis_test_XXXXXX";
    if (mkdtemp(name) == nullptr) throw std::runtime_error("mkdtemp failed");
    path_ = name;
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::string& path() const { return path_; }

private:
  std::string path_;
};

}  // namespace fourwis::can
