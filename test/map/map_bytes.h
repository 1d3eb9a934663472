#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "../support/random.h"
#include "fourwis_navigation/map/map_file.h"

namespace fourwis
{

/// A folder of its own for each test, removed at the end.
class TemporaryDirectory
{
public:
  TemporaryDirectory()
  {
    std::string name = (std::filesystem::temp_directory_path() / "fourwis_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
    path_ = name;
  }
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

private:
  std::filesystem::path path_;
};

/// Makes a new file: some file systems wait for the disk when an old one is cut to nothing and written again.
inline void write_bytes(const std::string& path, const std::string& bytes)
{
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
}

inline std::string read_bytes(const std::string& path)
{
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

/// How a PNG is stored; samples of 16 bits are big endian.
struct PngKind
{
  int colour_type = PNG_COLOR_TYPE_GRAY;
  int depth = 8;
  bool is_interlaced = false;
};

/// A PNG of `width` pixels a row from rows of packed samples. Palettes hold the grey 5 * i at index i, transparent at
/// index 7.
inline std::string png_bytes(int width, std::vector<std::vector<std::uint8_t>> rows, const PngKind& kind)
{
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto append = [](png_structp p, png_bytep data, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(data), size);
  };
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(rows.size()), kind.depth,
               kind.colour_type, kind.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (kind.colour_type == PNG_COLOR_TYPE_PALETTE)
  {
    std::vector<png_color> palette;
    for (int i = 0; i < 52; ++i)
      palette.push_back({static_cast<png_byte>(5 * i), static_cast<png_byte>(5 * i), static_cast<png_byte>(5 * i)});
    png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    std::vector<png_byte> alpha(8, 255);
    alpha.back() = 0;
    png_set_tRNS(png, info, alpha.data(), static_cast<int>(alpha.size()), nullptr);
  }
  std::vector<png_bytep> pointers;
  for (auto& row : rows) pointers.push_back(row.data());
  png_set_rows(png, info, pointers.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

/// `bytes` with one to four random bits flipped or bytes replaced, cut short every third time.
inline std::string mutated(std::string bytes, Random& random)
{
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random.whole(0, static_cast<int>(n) - 1)); };
  for (std::size_t i = 0, n = 1 + below(4); i < n; ++i)
  {
    char& byte = bytes[below(bytes.size())];
    byte = static_cast<char>(below(2) == 0 ? byte ^ (1 << below(8)) : static_cast<int>(below(256)));
  }
  if (below(3) == 0) bytes.resize(below(bytes.size()));
  return bytes;
}

/// Calls `read`; what it may not do is throw anything but a MapFileError of one line. Returns its message, or "".
template <typename Read>
std::string message_of(const Read& read)
{
  try
  {
    read();
    return "";
  }
  catch (const MapFileError& error)
  {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }
}

}  // namespace fourwis
