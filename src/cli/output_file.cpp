#include "output_file.h"

#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{
namespace
{

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& why)
{
  reject<OutputError>(path == "-" ? "standard output" : path, ": cannot be written: ", why);
}

}  // namespace

OutputFile::OutputFile(const std::string& path, std::ostream* standard_output)
  : path_(path),
    target_(path),
    standard_output_(path == "-" ? standard_output : nullptr)
{
  if (standard_output_) return;

  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) fail(path, "it is a directory, expected a file");
  const bool device = fs::exists(status) && !fs::is_regular_file(status);
  if (!device)
  {
    // Through a symbolic link to the file it names, instead of replacing the link.
    if (fs::exists(status)) target_ = fs::canonical(path, error).string();
    if (error && fs::exists(status)) fail(path, error.message());
    written_ = target_ + ".part" + std::to_string(getpid());
  }
  file_.open(device ? target_ : written_, std::ios::binary | std::ios::trunc);
  if (!file_)
  {
    written_.clear();
    fail(path, "expected a file in a directory that exists and is writable");
  }
}

OutputFile::~OutputFile()
{
  std::error_code ignored;
  if (!written_.empty()) fs::remove(written_, ignored);
}

void OutputFile::commit()
{
  stream().flush();
  if (!standard_output_) file_.close();
  if (!stream()) fail(path_, "the disk may be full");
  if (written_.empty()) return;

  std::error_code error;
  fs::rename(written_, target_, error);
  if (error) fail(path_, error.message());
  written_.clear();
}

}  // namespace fourwis
