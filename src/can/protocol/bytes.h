#pragma once

#include <cstdint>
#include <type_traits>

namespace fourwis::can
{

/// Writes the bytes of a number, least significant first, and returns the place after them.
template <class Integer>
std::uint8_t* put_little_endian(Integer value, std::uint8_t* to)
{
  auto bits = static_cast<std::make_unsigned_t<Integer>>(value);
  for (unsigned i = 0; i < sizeof(Integer); ++i) *to++ = static_cast<std::uint8_t>(bits >> (8 * i));
  return to;
}

template <class Integer>
Integer get_little_endian(const std::uint8_t* from)
{
  std::make_unsigned_t<Integer> bits = 0;
  for (unsigned i = 0; i < sizeof(Integer); ++i)
    bits = static_cast<std::make_unsigned_t<Integer>>(bits | static_cast<std::uint64_t>(from[i]) << (8 * i));
  return static_cast<Integer>(bits);
}

/// Likewise, most significant first.
template <class Integer>
std::uint8_t* put_big_endian(Integer value, std::uint8_t* to)
{
  auto bits = static_cast<std::make_unsigned_t<Integer>>(value);
  for (unsigned i = sizeof(Integer); i-- > 0;) *to++ = static_cast<std::uint8_t>(bits >> (8 * i));
  return to;
}

template <class Integer>
Integer get_big_endian(const std::uint8_t* from)
{
  std::make_unsigned_t<Integer> bits = 0;
  for (unsigned i = 0; i < sizeof(Integer); ++i)
    bits = static_cast<std::make_unsigned_t<Integer>>(static_cast<std::uint64_t>(bits) << 8 | from[i]);
  return static_cast<Integer>(bits);
}

}  // namespace fourwis::can
