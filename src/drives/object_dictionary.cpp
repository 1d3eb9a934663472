#include "fourwis_navigation/drives/object_dictionary.h"

namespace fourwis::drives
{
namespace
{

bool is_writable(const Object& object)
{
  return object.use == ObjectUse::setting || object.use == ObjectUse::command;
}

/// The number that the bytes mean, in two's complement if the object is signed.
std::int64_t value_of(const Object& object, std::uint32_t bytes)
{
  const int unused = 64 - 8 * object.size;
  const std::uint64_t shifted = static_cast<std::uint64_t>(bytes) << unused;
  return object.low < 0 ? static_cast<std::int64_t>(shifted) >> unused : static_cast<std::int64_t>(shifted >> unused);
}

}  // namespace

const Object* ObjectDictionary::find(ObjectAddress address) const
{
  const auto found = objects_.find(address);
  return found == objects_.end() ? nullptr : &found->second;
}

AbortCode ObjectDictionary::existence(ObjectAddress address) const
{
  if (objects_.count(address) > 0) return AbortCode::none;
  const auto sibling = objects_.lower_bound({address.index, 0});
  return sibling != objects_.end() && sibling->first.index == address.index ? AbortCode::no_sub_index
                                                                            : AbortCode::no_object;
}

AbortCode ObjectDictionary::write(ObjectAddress address, std::uint8_t size, std::uint32_t bytes)
{
  const AbortCode missing = existence(address);
  if (missing != AbortCode::none) return missing;
  Object& object = objects_.at(address);
  if (!is_writable(object)) return AbortCode::read_only;
  if (size != object.size) return AbortCode::wrong_size;
  const std::int64_t value = value_of(object, bytes);
  if (value > object.high) return AbortCode::value_too_high;
  if (value < object.low) return AbortCode::value_too_low;
  for (const Rule& rule : rules_)
  {
    const AbortCode code = rule(*this, address, value);
    if (code != AbortCode::none) return code;
  }
  object.value = value;
  if (listener_) listener_(address);
  return AbortCode::none;
}

void ObjectDictionary::restore(const ObjectDictionary& from, std::uint16_t first, std::uint16_t last)
{
  const auto end = from.objects_.upper_bound({last, 0xFF});
  for (auto object = from.objects_.lower_bound({first, 0}); object != end; ++object)
    set(object->first, object->second.value);
}

std::uint32_t bytes_of(const Object& object)
{
  const auto bits = static_cast<std::uint32_t>(object.value);
  return object.size == 4 ? bits : bits & ((1u << (8 * object.size)) - 1);
}

}  // namespace fourwis::drives
