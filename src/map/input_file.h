#pragma once

#include <string>

namespace fourwis
{

/// A whole file in memory. Nothing in it is trusted; its readers report a defect through reject().
struct InputFile
{
  std::string path;
  std::string bytes;

  /// Throws MapFileError: one line "path: field: reason", without control characters.
  [[noreturn]] void reject(const std::string& field, const std::string& reason) const;
};

/// Throws MapFileError when the file is missing, not a regular file, unreadable or larger than `max_bytes`.
InputFile read_input_file(const std::string& path, std::size_t max_bytes);

/// Throws MapFileError "path: field: reason", for files that are not in memory.
[[noreturn]] void reject_file(const std::string& path, const std::string& field, const std::string& reason);

/// Text from a file as it may appear in a message: quoted, cut to a sensible length.
std::string quoted(const std::string& text);

/// More cells than any real map has; a guard against nonsense in headers.
constexpr long long max_map_cells = 1LL << 28;

/// Larger than any file of a map with that many cells.
constexpr std::size_t max_map_bytes = std::size_t{1} << 31;

}  // namespace fourwis
