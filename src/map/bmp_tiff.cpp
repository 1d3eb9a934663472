#include <memory>

#include <leptonica/allheaders.h>

#include "image.h"

namespace fourwis
{
namespace
{

struct Destroy
{
  void operator()(Pix* pix) const { pixDestroy(&pix); }
};
using Picture = std::unique_ptr<Pix, Destroy>;

/// What goes wrong is said once, by us. For the whole process, so once is enough; true.
bool silence_leptonica()
{
  setMsgSeverity(L_SEVERITY_NONE);
#if LIBLEPT_MAJOR_VERSION > 1 || LIBLEPT_MINOR_VERSION >= 80  // older ones cannot be told
  leptSetStderrHandler([](const char*) {});
#endif
  return true;
}

/// Throws MapFileError unless the header is complete and its size that of a map: nothing is allocated before.
void check_header(const InputFile& file, const char* format)
{
  l_int32 code = 0, width = 0, height = 0, depth = 0, samples = 0, has_palette = 0;
  if (pixReadHeaderMem(reinterpret_cast<const l_uint8*>(file.bytes.data()), file.bytes.size(), &code, &width, &height,
                       &depth, &samples, &has_palette) != 0)
    file.reject("header", std::string("expected a complete ") + format + " that Leptonica reads");
  check_image_size(file, width, height);
}

/// Grey of 8 bits or RGB, whatever the depth was, without a palette. Null where that cannot be.
Picture plain(Picture picture)
{
  if (picture && pixGetColormap(picture.get()))
    picture.reset(pixRemoveColormap(picture.get(), REMOVE_CMAP_BASED_ON_SRC));
  if (picture && pixGetDepth(picture.get()) != 8 && pixGetDepth(picture.get()) != 32)
    picture.reset(pixConvertTo8(picture.get(), 0));
  return picture;
}

/// `has_alpha`: whether a fourth sample of a pixel tells how opaque it is.
Image decode(const InputFile& file, const char* format, bool has_alpha)
{
  [[maybe_unused]] static const bool is_silent = silence_leptonica();
  check_header(file, format);
  const auto* bytes = reinterpret_cast<const l_uint8*>(file.bytes.data());
  const Picture picture = plain(Picture(pixReadMem(bytes, file.bytes.size())));
  if (!picture) file.reject("pixels", std::string("expected a complete ") + format + " that Leptonica reads");

  const l_int32 width = pixGetWidth(picture.get()), height = pixGetHeight(picture.get());
  check_image_size(file, width, height);
  const bool is_grey = pixGetDepth(picture.get()) == 8;
  Image image{width, height, is_grey ? 1 : 3, has_alpha && !is_grey && pixGetSpp(picture.get()) == 4, {}};
  image.samples.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                        static_cast<std::size_t>(image.channels()));
  for (l_int32 row = 0; row < height; ++row)
  {
    const l_uint32* line = pixGetData(picture.get()) + static_cast<std::ptrdiff_t>(row) * pixGetWpl(picture.get());
    for (l_int32 column = 0; column < width; ++column)
    {
      if (is_grey)
      {
        image.samples.push_back(static_cast<std::uint8_t>(GET_DATA_BYTE(line, column)));
        continue;
      }
      for (int sample = 0; sample < image.channels(); ++sample)  // red is the highest byte, alpha the lowest
        image.samples.push_back(static_cast<std::uint8_t>(line[column] >> (24 - 8 * sample)));
    }
  }
  return image;
}

}  // namespace

Image decode_bmp(const InputFile& file)
{
  return decode(file, "BMP", false);
}

Image decode_tiff(const InputFile& file)
{
  return decode(file, "TIFF", true);
}

}  // namespace fourwis
