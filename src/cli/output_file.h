#pragma once

#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>

namespace fourwis
{

/// An output that cannot be written. what() names it.
struct OutputError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file that appears under its name as a whole or not at all: it is written beside its place and moved there by
/// commit(). Devices and pipes are written directly.
class OutputFile
{
public:
  /// Throws OutputError when nothing can be written there. The path "-" means `standard_output` where that is given.
  explicit OutputFile(const std::string& path, std::ostream* standard_output = nullptr);
  ~OutputFile();  ///< leaves no trace of what was not committed
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream() { return standard_output_ ? *standard_output_ : file_; }

  /// Throws OutputError when not everything could be written.
  void commit();

private:
  std::string path_;     ///< as the user gave it
  std::string target_;   ///< where the file goes
  std::string written_;  ///< where it is written until then; empty when it is written in place or done
  std::ofstream file_;
  std::ostream* standard_output_;
};

}  // namespace fourwis
