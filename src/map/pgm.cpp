#include <algorithm>
#include <cctype>

#include "image.h"

namespace fourwis
{
namespace
{

bool is_space(char c)
{
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool is_digit(char c)
{
  return c >= '0' && c <= '9';
}

/// Reads the tokens of a Netpbm file in order.
class PgmReader
{
public:
  explicit PgmReader(const InputFile& file) : file_(file), bytes_(file.bytes), position_(2) {}

  /// The next decimal number, after white space and comments; numbers beyond every limit are cut short.
  long long number(const char* field)
  {
    skip_space_and_comments();
    if (position_ == bytes_.size()) file_.reject(field, "truncated, expected a number");
    if (!is_digit(bytes_[position_])) file_.reject(field, "expected a number");
    long long value = 0;
    for (; position_ < bytes_.size() && is_digit(bytes_[position_]); ++position_)
      value = std::min(10 * value + (bytes_[position_] - '0'), too_large);
    return value;
  }

  /// The single white space that separates the header from binary samples; a comment may stand before it.
  void end_of_header()
  {
    if (position_ < bytes_.size() && bytes_[position_] == '#')
      position_ = std::min(bytes_.find('\n', position_), bytes_.size());
    if (position_ == bytes_.size() || !is_space(bytes_[position_]))
      file_.reject("maxval", "expected white space after it");
    ++position_;
  }

  /// The next `size` bytes, big endian.
  long long binary(int size)
  {
    long long value = 0;
    for (int i = 0; i < size; ++i) value = 256 * value + static_cast<unsigned char>(bytes_[position_++]);
    return value;
  }

  /// Throws MapFileError unless at least `size` more bytes follow.
  void expect_bytes(long long size) const
  {
    const auto left = static_cast<long long>(bytes_.size() - position_);
    if (left < size)
    {
      file_.reject("pixels",
                   "truncated, expected at least " + std::to_string(size) + " bytes, got " + std::to_string(left));
    }
  }

private:
  static constexpr long long too_large = 1'000'000'000;

  void skip_space_and_comments()
  {
    for (; position_ < bytes_.size() && (is_space(bytes_[position_]) || bytes_[position_] == '#'); ++position_)
    {
      if (bytes_[position_] == '#') position_ = std::min(bytes_.find('\n', position_), bytes_.size() - 1);
    }
  }

  const InputFile& file_;
  const std::string& bytes_;
  std::size_t position_;
};

}  // namespace

Image decode_pgm(const InputFile& file)
{
  PgmReader reader(file);
  const long long width = reader.number("width");
  const long long height = reader.number("height");
  check_image_size(file, width, height);
  const long long maxval = reader.number("maxval");
  if (maxval < 1 || maxval > 65535) file.reject("maxval", "expected 1 to 65535, got " + std::to_string(maxval));
  reader.end_of_header();

  const bool is_binary = file.bytes[1] == '5';
  const int sample_size = maxval > 255 ? 2 : 1;
  const long long pixels = width * height;
  // A plain sample takes a digit and a separator, the last one only the digit.
  reader.expect_bytes(is_binary ? pixels * sample_size : 2 * pixels - 1);

  Image image{static_cast<int>(width), static_cast<int>(height), 1, false, {}};
  image.samples.reserve(static_cast<std::size_t>(pixels));
  for (long long i = 0; i < pixels; ++i)
  {
    const long long sample = is_binary ? reader.binary(sample_size) : reader.number("pixels");
    if (sample > maxval)
      file.reject("pixels", "expected 0 to maxval " + std::to_string(maxval) + ", got " + std::to_string(sample));
    image.samples.push_back(static_cast<std::uint8_t>(sample * 255 / maxval));
  }
  return image;
}

}  // namespace fourwis
