#include "image.h"

namespace fourwis
{
namespace
{

bool starts_with(const std::string& text, const std::string& prefix)
{
  return text.compare(0, prefix.size(), prefix) == 0;
}

}  // namespace

Image read_image(const std::string& path)
{
  const InputFile file = read_input_file(path, max_map_bytes);
  if (starts_with(file.bytes, "P2") || starts_with(file.bytes, "P5")) return decode_pgm(file);
  if (starts_with(file.bytes, "\x89PNG")) return decode_png(file);
  if (starts_with(file.bytes, "\xff\xd8\xff")) return decode_jpeg(file);
  if (starts_with(file.bytes, "BM")) return decode_bmp(file);
  if (starts_with(file.bytes, {"II*\0", 4}) || starts_with(file.bytes, {"MM\0*", 4})) return decode_tiff(file);
  file.reject("format", "expected a PGM (P2 or P5), PNG, JPEG, BMP or TIFF image");
}

void check_image_size(const InputFile& file, long long width, long long height)
{
  if (width >= 1 && height >= 1 && width <= max_map_cells / height) return;
  file.reject("size", "expected 1 to " + std::to_string(max_map_cells) + " pixels, got " + std::to_string(width) +
                          " x " + std::to_string(height));
}

}  // namespace fourwis
