#include "bus_directory.h"

#include <sys/inotify.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace fourwis::can
{
namespace
{

constexpr std::uint32_t kWatched = IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

std::string root()
{
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && *runtime == '/') return std::string(runtime) + "/fourwis_can";
  return "/tmp/fourwis_can_" + std::to_string(geteuid());
}

/// Empty if `path` is a directory to which only this user has access, otherwise why not.
std::string make_private(const std::string& path)
{
  if (mkdir(path.c_str(), 0700) != 0 && errno != EEXIST) return path + ": " + std::strerror(errno);
  struct stat found;
  if (lstat(path.c_str(), &found) != 0) return path + ": " + std::strerror(errno);
  if (!S_ISDIR(found.st_mode)) return path + " is no directory";
  if (found.st_uid != geteuid() || (found.st_mode & 077) != 0) return path + " is not private (owner, mode 0700)";
  return "";
}

}  // namespace

BusDirectory::BusDirectory(const std::string& bus) : path_(root() + '/' + bus), error_(make_private(root()))
{
  if (error_.empty()) error_ = make_private(path_);
  if (!error_.empty()) return;
  watch_ = FileDescriptor(inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
  if (inotify_add_watch(watch_.get(), path_.c_str(), kWatched) < 0)
    error_ = path_ + " cannot be watched: " + std::strerror(errno);
}

bool BusDirectory::changed()
{
  alignas(inotify_event) char events[4096];
  bool any = false;
  while (read(watch_.get(), events, sizeof events) > 0) any = true;
  return any;
}

std::optional<std::set<std::string>> BusDirectory::ends() const
{
  std::error_code error;
  std::set<std::string> found;
  std::filesystem::directory_iterator entry(path_, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
    if (const std::string name = entry->path().filename().string(); name.front() != '.') found.insert(name);
  if (error) return std::nullopt;
  return found;
}

}  // namespace fourwis::can
