#include "errors.h"

#include <algorithm>

#include "frames.h"

namespace fourwis::drives
{
namespace
{

/// Bits of the error register: 0 any, 1 current, 2 voltage, 3 temperature, 4 communication, 5 of the device profile.
std::uint8_t register_of(std::uint16_t code)
{
  const std::uint8_t any = 0x01;
  switch (code >> 12)
  {
    case 2: return any | 0x02;
    case 3: return any | 0x04;
    case 4: return any | 0x08;
    case 8: return any | ((code >> 8) <= 0x82 ? 0x10 : 0x20);
    case 15: return any | 0x20;
    default: return any;
  }
}

/// The newest comes first.
void record(ObjectDictionary& dictionary, std::uint16_t code)
{
  for (std::uint8_t k = kErrorsKept; k > 1; --k)
    dictionary.set({object::kErrorHistory, k}, dictionary.get(object::kErrorHistory, k - 1));
  dictionary.set({object::kErrorHistory, 1}, code);
  const std::int64_t count = dictionary.get(object::kErrorHistory, 0);
  dictionary.set({object::kErrorHistory, 0}, std::min<std::int64_t>(count + 1, kErrorsKept));
}

can::Frame emergency(const ObjectDictionary& dictionary, std::uint8_t node, std::uint16_t code)
{
  can::Frame frame = data_frame(cob::kEmergency + node, 8);
  put_bytes(frame, 0, 2, code);
  frame.data[2] = static_cast<std::uint8_t>(dictionary.get(object::kErrorRegister));
  return frame;
}

}  // namespace

can::Frame record_error(ObjectDictionary& dictionary, std::uint8_t node, std::uint16_t code)
{
  dictionary.set(object::kErrorRegister, dictionary.get(object::kErrorRegister) | register_of(code));
  dictionary.set(object::kErrorCode, code);
  record(dictionary, code);
  return emergency(dictionary, node, code);
}

can::Frame clear_errors(ObjectDictionary& dictionary, std::uint8_t node)
{
  dictionary.set(object::kErrorRegister, 0);
  dictionary.set(object::kErrorCode, 0);
  return emergency(dictionary, node, 0);
}

}  // namespace fourwis::drives
