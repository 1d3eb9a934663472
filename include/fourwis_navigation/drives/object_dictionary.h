#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace fourwis::drives
{

/// Why an SDO transfer is refused (CiA 301, 7.2.4.3.17). A fault may use any other number.
enum class AbortCode : std::uint32_t
{
  none = 0,
  toggle_bit = 0x05030000,
  timeout = 0x05040000,
  unknown_command = 0x05040001,
  unsupported_access = 0x06010000,
  read_only = 0x06010002,
  no_object = 0x06020000,
  not_mappable = 0x06040041,
  pdo_too_long = 0x06040042,
  wrong_size = 0x06070010,
  no_sub_index = 0x06090011,
  invalid_value = 0x06090030,
  value_too_high = 0x06090031,
  value_too_low = 0x06090032,
  general = 0x08000000,
  device_state = 0x08000022
};

/// Index and sub-index.
struct ObjectAddress
{
  std::uint16_t index = 0;
  std::uint8_t sub = 0;

  friend bool operator<(ObjectAddress a, ObjectAddress b)
  {
    return std::pair(a.index, a.sub) < std::pair(b.index, b.sub);
  }
  friend bool operator==(ObjectAddress a, ObjectAddress b) { return a.index == b.index && a.sub == b.sub; }
};

/// The access to an object from the bus.
enum class ObjectUse
{
  constant,  ///< read
  status,    ///< read, mapped into a TPDO
  setting,   ///< read and written
  command    ///< read and written, mapped into an RPDO
};

/// One number in a device.
struct Object
{
  std::uint8_t size = 4;  ///< [byte], 1, 2 or 4
  ObjectUse use = ObjectUse::constant;
  std::int64_t value = 0;
  std::int64_t low = 0, high = 0xFFFFFFFF;  ///< the values that may be written; a negative `low` means a signed number
};

/// All objects of a device that can be read and written over the bus, as numbers of up to four bytes.
class ObjectDictionary
{
public:
  /// A further check of a value that is in range: why it is refused, or `none`.
  using Rule = std::function<AbortCode(const ObjectDictionary&, ObjectAddress, std::int64_t value)>;
  using Listener = std::function<void(ObjectAddress)>;

  void add(ObjectAddress address, const Object& object) { objects_[address] = object; }
  void add_rule(Rule rule) { rules_.push_back(std::move(rule)); }
  /// Called after an object was written over the bus.
  void listen(Listener listener) { listener_ = std::move(listener); }

  /// The object, or null if it does not exist.
  const Object* find(ObjectAddress address) const;
  /// `none` if the object exists, otherwise whether the index or the sub-index is missing.
  AbortCode existence(ObjectAddress address) const;

  /// Writes an object from the bus: `size` bytes, least significant first in `bytes`. A refused value changes nothing.
  AbortCode write(ObjectAddress address, std::uint8_t size, std::uint32_t bytes);

  /// Access of the device itself. Throws std::out_of_range if the object does not exist.
  std::int64_t get(std::uint16_t index, std::uint8_t sub = 0) const { return objects_.at({index, sub}).value; }
  void set(ObjectAddress address, std::int64_t value) { objects_.at(address).value = value; }
  void set(std::uint16_t index, std::int64_t value) { set({index, 0}, value); }

  /// Copies the values of all objects from index `first` to `last`.
  void restore(const ObjectDictionary& from, std::uint16_t first, std::uint16_t last);

private:
  std::map<ObjectAddress, Object> objects_;
  std::vector<Rule> rules_;
  Listener listener_;
};

/// The bytes of a value on the bus, least significant first.
std::uint32_t bytes_of(const Object& object);

}  // namespace fourwis::drives
