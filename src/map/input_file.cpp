#include "input_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{

void reject_file(const std::string& path, const std::string& field, const std::string& reason)
{
  std::string line = path + ": " + field + ": " + reason;
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  std::replace_if(line.begin(), line.end(), is_control, ' ');
  fourwis::reject<MapFileError>(line);
}

void InputFile::reject(const std::string& field, const std::string& reason) const
{
  reject_file(path, field, reason);
}

InputFile read_input_file(const std::string& path, std::size_t max_bytes)
{
  // Opening a pipe would block and a directory reads as empty, so ask before.
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) reject_file(path, "file", "expected an existing file");
  if (!std::filesystem::is_regular_file(status)) reject_file(path, "file", "expected a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) reject_file(path, "file", "expected a readable file (" + error.message() + ")");
  if (size > max_bytes)
    reject_file(path, "file", "expected at most " + std::to_string(max_bytes) + " bytes, got " + std::to_string(size));

  std::ifstream stream(path, std::ios::binary);
  InputFile file{path, std::string(static_cast<std::size_t>(size), '\0')};
  if (!stream || !stream.read(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size())))
    reject_file(path, "file", "expected a readable file");
  return file;
}

std::string quoted(const std::string& text)
{
  constexpr std::size_t longest = 60;
  return '"' + (text.size() <= longest ? text : text.substr(0, longest) + "...") + '"';
}

}  // namespace fourwis
