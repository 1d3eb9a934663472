#pragma once

#include <optional>
#include <set>
#include <string>

#include "fourwis_navigation/can/bus/file_descriptor.h"

namespace fourwis::can
{

/// The directory of a UnixBus, which holds one socket for each end: in $XDG_RUNTIME_DIR/fourwis_can or, where that is
/// not set, /tmp/fourwis_can_UID. Only its user has access. Names with a leading dot do not count.
class BusDirectory
{
public:
  /// Creates the directory if it is missing, and watches it. `error()` is empty if that succeeded.
  explicit BusDirectory(const std::string& bus);

  const std::string& path() const { return path_; }
  const std::string& error() const { return error_; }

  /// A file descriptor that becomes readable with a change.
  int descriptor() const { return watch_.get(); }
  /// Whether an end has come or gone since the last call.
  bool changed();

  /// File names of all ends; none if the directory is gone.
  std::optional<std::set<std::string>> ends() const;
  std::string file(const std::string& end) const { return path_ + '/' + end; }

private:
  std::string path_;
  std::string error_;
  FileDescriptor watch_;
};

}  // namespace fourwis::can
