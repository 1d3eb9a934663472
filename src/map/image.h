#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "input_file.h"

namespace fourwis
{

/// A picture of 8-bit samples, row 0 on top. Each pixel has its colour samples, then alpha if there is one.
struct Image
{
  int width = 0;
  int height = 0;
  int colours = 1;         ///< 1 (grey) or 3
  bool has_alpha = false;  ///< alpha: 255 opaque, 0 transparent
  std::vector<std::uint8_t> samples;

  int channels() const { return has_alpha ? colours + 1 : colours; }

  /// The samples of one pixel.
  const std::uint8_t* pixel(int column, int row) const
  {
    const auto index = static_cast<std::ptrdiff_t>(row) * width + column;
    return samples.data() + index * channels();
  }
};

/// Reads a PGM (P2, P5), PNG, JPEG, BMP or TIFF file, told apart by content. Throws MapFileError.
Image read_image(const std::string& path);

/// The formats behind read_image(). Deeper samples are reduced to 8 bits as map_server's image library does, palettes are
/// resolved. Their libraries write nothing to the console, and are given no size that check_image_size() rejects.
Image decode_pgm(const InputFile& file);
Image decode_png(const InputFile& file);
Image decode_jpeg(const InputFile& file);
Image decode_bmp(const InputFile& file);
Image decode_tiff(const InputFile& file);

/// Throws MapFileError unless a header's size is one of a real map: at least 1 x 1, at most max_map_cells.
void check_image_size(const InputFile& file, long long width, long long height);

}  // namespace fourwis
