#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>

#include "image.h"

namespace fourwis
{
namespace
{

/// One decoding by libpng, which reports errors by longjmp: the members below that call setjmp() hold no object with a
/// destructor, and return false with error() set.
class PngReader
{
public:
  explicit PngReader(const InputFile& file) : file_(file)
  {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (info_) png_set_read_fn(png_, this, on_read);
  }

  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  bool is_ready() const { return info_ != nullptr; }
  const char* error() const { return error_; }
  png_uint_32 width() const { return png_get_image_width(png_, info_); }
  png_uint_32 height() const { return png_get_image_height(png_, info_); }
  int channels() const { return png_get_channels(png_, info_); }
  std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }

  bool read_header()
  {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_info(png_, info_);
    return true;
  }

  /// Makes every kind of PNG 8 bits per sample, palette and transparent colours resolved.
  bool expand()
  {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_expand(png_);
    png_set_strip_16(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  bool read_pixels(png_bytepp rows)
  {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

private:
  static void on_read(png_structp png, png_bytep out, std::size_t size)
  {
    auto* self = static_cast<PngReader*>(png_get_io_ptr(png));
    if (size > self->file_.bytes.size() - self->position_) png_error(png, "truncated");
    std::memcpy(out, self->file_.bytes.data() + self->position_, size);
    self->position_ += size;
  }

  [[noreturn]] static void on_error(png_structp png, png_const_charp message)
  {
    auto* self = static_cast<PngReader*>(png_get_error_ptr(png));
    std::strncpy(self->error_, message, sizeof self->error_ - 1);
    png_longjmp(png, 1);
  }

  static void on_warning(png_structp, png_const_charp) {}

  const InputFile& file_;
  std::size_t position_ = 0;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  char error_[128] = "out of memory";
};

}  // namespace

Image decode_png(const InputFile& file)
{
  PngReader reader(file);
  if (!reader.is_ready() || !reader.read_header())
    file.reject("header", std::string("expected a complete PNG header: ") + reader.error());
  check_image_size(file, reader.width(), reader.height());
  // Deflate shrinks by at most 1032, so a small file cannot hold a large picture.
  if (reader.row_bytes() * reader.height() > 1032 * file.bytes.size())
    file.reject("pixels", "truncated, the file is too short for its size of " + std::to_string(reader.width()) + " x " +
                              std::to_string(reader.height()));
  if (!reader.expand())
    file.reject("header", std::string("expected a PNG that libpng can convert to 8 bits: ") + reader.error());

  const int channels = reader.channels();
  Image image{
      static_cast<int>(reader.width()), static_cast<int>(reader.height()), channels < 3 ? 1 : 3, channels % 2 == 0, {}};
  image.samples.resize(reader.row_bytes() * reader.height());
  std::vector<png_bytep> rows(reader.height());
  for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = image.samples.data() + row * reader.row_bytes();
  if (!reader.read_pixels(rows.data()))
    file.reject("pixels", std::string("expected complete PNG data: ") + reader.error());
  return image;
}

}  // namespace fourwis
