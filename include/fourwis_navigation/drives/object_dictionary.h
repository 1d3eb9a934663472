#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace fourwis::drives
{

/// Why an SDO transfer is refused (CiA 301, 7.2.4.3.17). Any other number that a fault makes up is as good.
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

/// What the bus may do with an object.
enum class ObjectUse
{
  constant,  ///< read
  status,    ///< read, mapped into a TPDO
  setting,   ///< read and written
  command    ///< read and written, mapped into an RPDO
};

/// One number of a device.
struct Object
{
  std::uint8_t size = 4;  ///< [byte], 1, 2 or 4
  ObjectUse use = ObjectUse::constant;
  std::int64_t value = 0;
  std::int64_t low = 0, high = 0xFFFFFFFF;  ///< what may be written; below zero: the number is signed
};

/// Everything of a device that can be read and written over the bus, as numbers of up to four bytes.
class ObjectDictionary
{
public:
  /// A reason to refuse a value that is in range; `none` where there is none.
  using Rule = std::function<AbortCode(const ObjectDictionary&, ObjectAddress, std::int64_t value)>;
  using Listener = std::function<void(ObjectAddress)>;

  void add(ObjectAddress address, const Object& object) { objects_[address] = object; }
  void add_rule(Rule rule) { rules_.push_back(std::move(rule)); }
  /// Is told of what the bus has written.
  void listen(Listener listener) { listener_ = std::move(listener); }

  /// Null where there is none.
  const Object* find(ObjectAddress address) const;
  /// Whether there is one, else which of the two is missing.
  AbortCode existence(ObjectAddress address) const;

  /// As the bus writes it: `size` bytes, least significant first in `bytes`. A refused value changes nothing.
  AbortCode write(ObjectAddress address, std::uint8_t size, std::uint32_t bytes);

  /// As the device itself sees it. Throws std::out_of_range where there is no such object.
  std::int64_t get(std::uint16_t index, std::uint8_t sub = 0) const { return objects_.at({index, sub}).value; }
  void set(ObjectAddress address, std::int64_t value) { objects_.at(address).value = value; }
  void set(std::uint16_t index, std::int64_t value) { set({index, 0}, value); }

  /// Takes over the values of all objects from `first` to `last`.
  void restore(const ObjectDictionary& from, std::uint16_t first, std::uint16_t last);

private:
  std::map<ObjectAddress, Object> objects_;
  std::vector<Rule> rules_;
  Listener listener_;
};

/// The bytes of a value on the bus, least significant first.
std::uint32_t bytes_of(const Object& object);

}  // namespace fourwis::drives
