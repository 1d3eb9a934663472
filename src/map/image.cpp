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
  file.reject("format", "expected a PGM (P2 or P5) or PNG image");
}

void check_image_size(const InputFile& file, long long width, long long height)
{
  if (width >= 1 && height >= 1 && width <= max_map_cells / height) return;
  file.reject("size", "expected 1 to " + std::to_string(max_map_cells) + " pixels, got " + std::to_string(width) +
                          " x " + std::to_string(height));
}

}  // namespace fourwis
