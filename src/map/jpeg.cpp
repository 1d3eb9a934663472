#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

#include "image.h"

namespace fourwis
{
namespace
{

/// One decoding by libjpeg, which reports errors by longjmp: the members below that call setjmp() hold no object with a
/// destructor, and return false with error() set.
class JpegReader
{
public:
  explicit JpegReader(const InputFile& file) : file_(file)
  {
    jpeg_.err = jpeg_std_error(&handlers_);
    handlers_.error_exit = on_error;
    handlers_.emit_message = on_message;
    jpeg_.client_data = this;
    is_ready_ = create();
  }

  ~JpegReader()
  {
    if (is_ready_) jpeg_destroy_decompress(&jpeg_);
  }

  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  const char* error() const { return error_; }
  JDIMENSION width() const { return jpeg_.image_width; }
  JDIMENSION height() const { return jpeg_.image_height; }
  int components() const { return jpeg_.num_components; }

  bool read_header()
  {
    if (!is_ready_ || setjmp(escape_)) return false;
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(file_.bytes.data()), file_.bytes.size());
    jpeg_read_header(&jpeg_, TRUE);
    return true;
  }

  /// Rows of 8-bit samples from `out` on, grey or RGB.
  bool read_pixels(std::uint8_t* out)
  {
    if (setjmp(escape_)) return false;
    reads_pixels_ = true;
    jpeg_.out_color_space = components() == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height)
    {
      JSAMPROW row =
          out + static_cast<std::size_t>(jpeg_.output_scanline) * width() * static_cast<std::size_t>(components());
      jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
  }

private:
  bool create()
  {
    if (setjmp(escape_)) return false;
    jpeg_create_decompress(&jpeg_);
    return true;
  }

  [[noreturn]] static void on_error(j_common_ptr jpeg)
  {
    auto* self = static_cast<JpegReader*>(jpeg->client_data);
    jpeg->err->format_message(jpeg, self->error_);
    std::longjmp(self->escape_, 1);
  }

  /// A warning while pixels are read says that some are made up: where the data is cut short or damaged.
  static void on_message(j_common_ptr jpeg, int level)
  {
    if (level < 0 && static_cast<JpegReader*>(jpeg->client_data)->reads_pixels_) on_error(jpeg);
  }

  const InputFile& file_;
  jpeg_decompress_struct jpeg_{};
  jpeg_error_mgr handlers_{};
  std::jmp_buf escape_{};
  bool is_ready_ = false, reads_pixels_ = false;
  char error_[JMSG_LENGTH_MAX] = "";
};

}  // namespace

Image decode_jpeg(const InputFile& file)
{
  JpegReader reader(file);
  if (!reader.read_header()) file.reject("header", std::string("expected a complete JPEG header: ") + reader.error());
  check_image_size(file, reader.width(), reader.height());
  const int colours = reader.components();
  if (colours != 1 && colours != 3)
    file.reject("header", "expected a grey or RGB JPEG, got " + std::to_string(colours) + " colour components");
  Image image{static_cast<int>(reader.width()), static_cast<int>(reader.height()), colours, false, {}};
  image.samples.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                       static_cast<std::size_t>(colours));
  if (!reader.read_pixels(image.samples.data()))
    file.reject("pixels", std::string("expected complete JPEG data: ") + reader.error());
  return image;
}

}  // namespace fourwis
