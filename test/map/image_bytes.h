#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <jpeglib.h>

namespace fourwis
{

/// Rows of samples, the topmost first, packed as the format has them.
using Rows = std::vector<std::vector<std::uint8_t>>;

inline std::string little(std::uint32_t value, int bytes)
{
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
  return text;
}

/// An uncompressed BMP; samples are blue, green, red, and with 32 bits one that means nothing. With 8 bits its palette holds
/// the grey 255 - i at index i.
inline std::string bmp_bytes(std::uint32_t width, const Rows& rows, std::uint32_t bits)
{
  std::string palette, pixels;
  for (std::uint32_t i = 0; bits == 8 && i < 256; ++i) palette += little((255 - i) * 0x010101, 4);
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
  {
    pixels.append(row->begin(), row->end());
    while (pixels.size() % 4 != 0) pixels += '\0';
  }
  const auto offset = static_cast<std::uint32_t>(54 + palette.size());
  const auto size = static_cast<std::uint32_t>(offset + pixels.size());
  return "BM" + little(size, 4) + little(0, 4) + little(offset, 4) + little(40, 4) + little(width, 4) +
         little(static_cast<std::uint32_t>(rows.size()), 4) + little(1, 2) + little(bits, 2) + little(0, 4) +
         little(static_cast<std::uint32_t>(pixels.size()), 4) + little(2835, 4) + little(2835, 4) +
         little(bits == 8 ? 256 : 0, 4) + little(0, 4) + palette + pixels;
}

/// An uncompressed TIFF of 8 bits a sample: 1 is grey, 3 RGB, 4 has alpha as well.
inline std::string tiff_bytes(std::uint32_t width, const Rows& rows, std::uint32_t samples)
{
  constexpr std::uint32_t shorts = 3, longs = 4, entries = 11;
  std::string pixels;
  for (const auto& row : rows) pixels.append(row.begin(), row.end());
  const std::uint32_t depths = 8 + 2 + 12 * entries + 4, data = depths + 8;
  const auto height = static_cast<std::uint32_t>(rows.size());
  const auto entry = [](std::uint32_t tag, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
    return little(tag, 2) + little(type, 2) + little(count, 4) + little(value, 4);
  };
  std::string bytes = std::string("II*\0", 4) + little(8, 4) + little(entries, 2);
  bytes += entry(256, longs, 1, width) + entry(257, longs, 1, height);
  bytes += entry(258, shorts, samples, samples == 1 ? 8 : depths);
  bytes += entry(259, shorts, 1, 1) + entry(262, shorts, 1, samples == 1 ? 1 : 2);
  bytes += entry(273, longs, 1, data) + entry(277, shorts, 1, samples) + entry(278, longs, 1, height);
  bytes += entry(279, longs, 1, static_cast<std::uint32_t>(pixels.size())) + entry(284, shorts, 1, 1);
  bytes += entry(338, shorts, samples == 4 ? 1 : 0, 2) + little(0, 4);
  for (int i = 0; i < 4; ++i) bytes += little(8, 2);
  return bytes + pixels;
}

/// A JPEG of the best quality, of 1 sample a pixel (grey) or 3 (RGB).
inline std::string jpeg_bytes(std::uint32_t width, Rows rows, int samples)
{
  jpeg_compress_struct jpeg;
  jpeg_error_mgr errors;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* out = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &out, &size);
  jpeg.image_width = width;
  jpeg.image_height = static_cast<JDIMENSION>(rows.size());
  jpeg.input_components = samples;
  jpeg.in_color_space = samples == 1 ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  jpeg_start_compress(&jpeg, TRUE);
  for (auto& row : rows)
  {
    JSAMPROW samples_of_row = row.data();
    jpeg_write_scanlines(&jpeg, &samples_of_row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string bytes(reinterpret_cast<char*>(out), size);
  std::free(out);
  return bytes;
}

}  // namespace fourwis
