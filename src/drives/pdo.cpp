#include "pdo.h"

#include <utility>

namespace fourwis::drives
{
namespace
{

struct Mapped
{
  ObjectAddress address;
  std::uint8_t size;  ///< [byte]
};

/// The objects of one PDO, in the order of their bytes.
class Mapping
{
public:
  Mapping(const ObjectDictionary& dictionary, std::uint16_t mapping)
    : count_(static_cast<std::uint8_t>(dictionary.get(mapping, 0)))
  {
    for (std::uint8_t k = 0; k < count_; ++k)
    {
      const auto entry = static_cast<std::uint32_t>(dictionary.get(mapping, k + 1));
      objects_[k] = {{static_cast<std::uint16_t>(entry >> 16), static_cast<std::uint8_t>(entry >> 8)},
                     static_cast<std::uint8_t>((entry & 0xFF) / 8)};
      size_ = static_cast<std::uint8_t>(size_ + objects_[k].size);
    }
  }

  const Mapped* begin() const { return objects_.data(); }
  const Mapped* end() const { return objects_.data() + count_; }
  std::uint8_t size() const { return size_; }  ///< of all together [byte]

private:
  std::array<Mapped, kMappedObjects> objects_{};
  std::uint8_t count_, size_ = 0;
};

std::uint32_t cob_of(const ObjectDictionary& dictionary, std::uint16_t parameters)
{
  return static_cast<std::uint32_t>(dictionary.get(parameters, 1));
}

bool is_synchronous(const ObjectDictionary& dictionary, std::uint16_t parameters)
{
  return dictionary.get(parameters, 2) <= 240;
}

std::optional<can::Frame> transmit_frame(const ObjectDictionary& dictionary, std::uint16_t pdo)
{
  const std::uint32_t cob = cob_of(dictionary, object::kTransmitParameters + pdo);
  if ((cob & kPdoInvalid) != 0) return std::nullopt;
  const Mapping mapping(dictionary, object::kTransmitMapping + pdo);
  if (mapping.size() == 0) return std::nullopt;
  can::Frame frame = data_frame(cob & 0x7FF, mapping.size());
  std::size_t at = 0;
  for (const Mapped& mapped : mapping)
  {
    put_bytes(frame, at, mapped.size, bytes_of(*dictionary.find(mapped.address)));
    at += mapped.size;
  }
  return frame;
}

}  // namespace

ReceivePdos::Outcome ReceivePdos::receive(const can::Frame& frame)
{
  for (std::uint16_t pdo = 0; pdo < kPdos; ++pdo)
  {
    const std::uint16_t parameters = object::kReceiveParameters + pdo;
    const std::uint32_t cob = cob_of(dictionary_, parameters);
    if ((cob & kPdoInvalid) != 0 || (cob & 0x7FF) != frame.id) continue;
    if (frame.size < Mapping(dictionary_, object::kReceiveMapping + pdo).size()) return Outcome::too_short;
    if (is_synchronous(dictionary_, parameters))
      waiting_[pdo] = frame;
    else
      apply(pdo, frame);
    return Outcome::taken;
  }
  return Outcome::not_ours;
}

void ReceivePdos::sync()
{
  for (int pdo = 0; pdo < kPdos; ++pdo)
    if (const std::optional<can::Frame> frame = std::exchange(waiting_[static_cast<std::size_t>(pdo)], std::nullopt))
      apply(pdo, *frame);
}

void ReceivePdos::apply(int pdo, const can::Frame& frame)
{
  const Mapping mapping(dictionary_, static_cast<std::uint16_t>(object::kReceiveMapping + pdo));
  if (frame.size < mapping.size()) return;  // the mapping has changed since the frame came
  std::size_t at = 0;
  for (const Mapped& mapped : mapping)
  {
    dictionary_.write(mapped.address, mapped.size, take_bytes(frame, at, mapped.size));
    at += mapped.size;
  }
}

void TransmitPdos::start()
{
  last_ = {};
}

void TransmitPdos::sync(const FrameSink& send)
{
  for (std::uint16_t pdo = 0; pdo < kPdos; ++pdo)
  {
    const std::uint16_t parameters = object::kTransmitParameters + pdo;
    if (!is_synchronous(dictionary_, parameters)) continue;
    const std::optional<can::Frame> frame = transmit_frame(dictionary_, pdo);
    if (!frame || ++last_[pdo].syncs < dictionary_.get(parameters, 2)) continue;
    last_[pdo].syncs = 0;
    send(*frame);
  }
}

void TransmitPdos::poll(double now, const FrameSink& send)
{
  for (std::uint16_t pdo = 0; pdo < kPdos; ++pdo)
  {
    if (is_synchronous(dictionary_, object::kTransmitParameters + pdo)) continue;
    const std::optional<can::Frame> frame = transmit_frame(dictionary_, pdo);
    if (!frame || !is_due(pdo, *frame, now)) continue;
    last_[pdo] = {frame, now, 0};
    send(*frame);
  }
}

bool TransmitPdos::is_due(int pdo, const can::Frame& frame, double now) const
{
  const Sent& last = last_[static_cast<std::size_t>(pdo)];
  if (!last.frame) return true;
  const auto parameters = static_cast<std::uint16_t>(object::kTransmitParameters + pdo);
  const double rounding = 1e-9, since = now - last.time + rounding;
  const auto event_timer = static_cast<double>(dictionary_.get(parameters, 5)) * 1e-3;
  const bool timer_ended = event_timer > 0.0 && since >= event_timer;
  const bool inhibited = since < static_cast<double>(dictionary_.get(parameters, 3)) * 1e-4;
  return timer_ended || (*last.frame != frame && !inhibited);
}

}  // namespace fourwis::drives
