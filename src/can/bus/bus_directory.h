#pragma once

#include <optional>
#include <set>
#include <string>

#include "fourwis_navigation/can/bus/file_descriptor.h"

namespace fourwis::can
{

/// Where the ends of a bus without kernel meet: a directory that holds one socket for each, in
/// $XDG_RUNTIME_DIR/fourwis_can or, where that is not set, /tmp/fourwis_can_UID. Only its user has access. Names with a
/// leading dot do not count.
class BusDirectory
{
public:
  /// Creates the directory where it is missing, and watches it. `error()` is empty when that went well.
  explicit BusDirectory(const std::string& bus);

  const std::string& path() const { return path_; }
  const std::string& error() const { return error_; }

  /// Becomes readable with a change.
  int descriptor() const { return watch_.get(); }
  /// Whether an end came or went since it was last asked.
  bool changed();

  /// File names of all ends; none where the directory is gone.
  std::optional<std::set<std::string>> ends() const;
  std::string file(const std::string& end) const { return path_ + '/' + end; }

private:
  std::string path_;
  std::string error_;
  FileDescriptor watch_;
};

}  // namespace fourwis::can
