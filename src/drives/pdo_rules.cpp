#include "pdo_rules.h"

#include "drive_objects.h"

namespace fourwis::drives
{
namespace
{

constexpr std::uint32_t kExtended = 1u << 29, kIdBits = 0x7FF;

bool is_among(std::uint16_t index, std::uint16_t first)
{
  return index >= first && index < first + kPdos;
}

bool exists(const ObjectDictionary& dictionary, std::uint16_t parameters)
{
  return (dictionary.get(parameters, 1) & kPdoInvalid) == 0;
}

/// Whether CiA 301 reserves the identifier for other services.
bool is_restricted(std::uint32_t id)
{
  return id <= 0x07F || (id >= 0x101 && id <= 0x180) || (id >= 0x581 && id <= 0x5FF) || (id >= 0x601 && id <= 0x67F) ||
         id >= 0x6E0;
}

AbortCode cob_abort_code(const ObjectDictionary& dictionary, std::uint16_t parameters, std::uint32_t value)
{
  if ((value & kExtended) != 0 || is_restricted(value & kIdBits)) return AbortCode::invalid_value;
  const bool other_id = ((value ^ dictionary.get(parameters, 1)) & kIdBits) != 0;
  return other_id && exists(dictionary, parameters) ? AbortCode::invalid_value : AbortCode::none;
}

/// Allowed transmission types: with every n-th SYNC, or event-driven; not on request, not acyclic with SYNC.
AbortCode type_abort_code(std::int64_t type)
{
  return (type >= 1 && type <= 240) || type >= 254 ? AbortCode::none : AbortCode::invalid_value;
}

AbortCode parameter_abort_code(const ObjectDictionary& dictionary, ObjectAddress address, std::int64_t value)
{
  if (address.sub == 1) return cob_abort_code(dictionary, address.index, static_cast<std::uint32_t>(value));
  if (address.sub == 2) return type_abort_code(value);
  return address.sub == 3 && exists(dictionary, address.index) ? AbortCode::unsupported_access : AbortCode::none;
}

/// A mapping of one object: index << 16 | sub-index << 8 | bits.
AbortCode entry_abort_code(const ObjectDictionary& dictionary, std::uint32_t entry, ObjectUse direction)
{
  const ObjectAddress mapped = {static_cast<std::uint16_t>(entry >> 16), static_cast<std::uint8_t>(entry >> 8)};
  const Object* object = dictionary.find(mapped);
  if (object == nullptr) return AbortCode::no_object;
  return object->use == direction && (entry & 0xFF) == 8u * object->size ? AbortCode::none : AbortCode::not_mappable;
}

AbortCode count_abort_code(const ObjectDictionary& dictionary, std::uint16_t mapping, std::int64_t count,
                           ObjectUse direction)
{
  std::uint32_t bits = 0;
  for (std::int64_t k = 1; k <= count; ++k)
  {
    const auto entry = static_cast<std::uint32_t>(dictionary.get(mapping, static_cast<std::uint8_t>(k)));
    const AbortCode code = entry_abort_code(dictionary, entry, direction);
    if (code != AbortCode::none) return code;
    bits += entry & 0xFF;
  }
  return bits > 64 ? AbortCode::pdo_too_long : AbortCode::none;
}

AbortCode mapping_abort_code(const ObjectDictionary& dictionary, ObjectAddress address, std::int64_t value,
                             std::uint16_t parameters, ObjectUse direction)
{
  if (exists(dictionary, parameters)) return AbortCode::unsupported_access;
  if (address.sub == 0) return count_abort_code(dictionary, address.index, value, direction);
  if (dictionary.get(address.index, 0) != 0) return AbortCode::unsupported_access;
  return entry_abort_code(dictionary, static_cast<std::uint32_t>(value), direction);
}

}  // namespace

AbortCode pdo_abort_code(const ObjectDictionary& dictionary, ObjectAddress address, std::int64_t value)
{
  const std::uint16_t index = address.index;
  if (is_among(index, object::kReceiveParameters) || is_among(index, object::kTransmitParameters))
    return parameter_abort_code(dictionary, address, value);
  if (is_among(index, object::kReceiveMapping))
    return mapping_abort_code(dictionary, address, value,
                              object::kReceiveParameters + (index - object::kReceiveMapping), ObjectUse::command);
  if (is_among(index, object::kTransmitMapping))
    return mapping_abort_code(dictionary, address, value,
                              object::kTransmitParameters + (index - object::kTransmitMapping), ObjectUse::status);
  return AbortCode::none;
}

}  // namespace fourwis::drives
