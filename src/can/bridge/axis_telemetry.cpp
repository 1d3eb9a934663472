#include "axis_telemetry.h"

namespace fourwis::can
{
namespace
{

/// Time between two requests to a drive, and between the requests to drives with successive node ids [s].
constexpr double kPeriod = 0.5, kStagger = 0.05;
constexpr ObjectId kSupplyVoltage{0x6079, 0};
constexpr double kMillivolt = 1e-3;

/// The value of an object as a signed number.
double signed_value(const SdoReply& reply)
{
  if (reply.size == 1) return static_cast<std::int8_t>(reply.value);
  if (reply.size == 2) return static_cast<std::int16_t>(reply.value);
  return static_cast<std::int32_t>(reply.value);
}

}  // namespace

AxisTelemetry::AxisTelemetry(const BridgeOptions& options, int node) : node_(node)
{
  const std::uint32_t temperature = options.temperature_object;
  items_[0] = {kSupplyVoltage, kMillivolt};
  items_[1] = {{static_cast<std::uint16_t>(temperature >> 8), static_cast<std::uint8_t>(temperature)},
               options.temperature_unit};
}

void AxisTelemetry::begin(double now)
{
  next_ = now + kStagger * node_;
}

void AxisTelemetry::supervise(double now, Outbox& outbox)
{
  if (now < next_) return;
  next_ = now + kPeriod;
  turn_ = (turn_ + 1) % items_.size();
  if (items_[turn_].object.index != 0) outbox.put(encode_sdo_read(node_, items_[turn_].object));
}

void AxisTelemetry::receive(const Frame& frame)
{
  const auto reply = decode_sdo_reply(frame);
  if (!reply) return;
  for (Item& item : items_)
  {
    if (reply->object != item.object) continue;
    if (reply->kind == SdoReply::Kind::value) item.value = item.unit * signed_value(*reply);
    if (reply->kind == SdoReply::Kind::abort) item.object.index = 0;
  }
}

}  // namespace fourwis::can
