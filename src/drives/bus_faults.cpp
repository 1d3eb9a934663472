#include "bus_faults.h"

#include "fourwis_navigation/can/protocol/frame_bits.h"

namespace fourwis::drives
{
namespace
{

constexpr double kPeriod = 0.01, kRounding = 1e-9;
/// linux/can/error.h
constexpr std::uint32_t kErrorController = 0x04, kErrorBusOff = 0x40;
constexpr std::uint8_t kPassiveBoth = 0x30, kPassiveCount = 128;

/// A command: a controlword that enables, the mode cyclic synchronous velocity for any axis, and a target.
can::Frame foreign_command(const DriveFault& fault)
{
  can::Frame frame = data_frame(cob::kFirstReceivePdo + static_cast<std::uint32_t>(fault.node), 7);
  put_bytes(frame, 0, 2, 0x0F);
  put_bytes(frame, 2, 1, 9);
  put_bytes(frame, 3, 4, static_cast<std::uint32_t>(fault.value));
  return frame;
}

can::Frame boot_up(const DriveFault& fault)
{
  return data_frame(cob::kHeartbeat + static_cast<std::uint32_t>(fault.node), 1);
}

/// The status of a node that is not enabled.
can::Frame idle_status(const DriveFault& fault)
{
  can::Frame frame = data_frame(cob::kFirstTransmitPdo + static_cast<std::uint32_t>(fault.node), 3);
  put_bytes(frame, 0, 2, 0x0250);
  return frame;
}

can::Frame error_frame(std::uint32_t error_class)
{
  can::Frame frame = data_frame(error_class, 8);
  frame.error = true;
  return frame;
}

can::Frame error_passive()
{
  can::Frame frame = error_frame(kErrorController);
  frame.data[1] = kPassiveBoth;
  frame.data[6] = frame.data[7] = kPassiveCount;
  return frame;
}

}  // namespace

void BusFaults::step(double now, double dt, const FrameSink& send)
{
  const bool cycle = now >= cycle_ + kPeriod - kRounding;
  if (cycle) cycle_ = now;
  faults_.for_each_active([&](const DriveFault& fault, bool begins) {
    if (fault.kind == DriveFaultKind::foreign_master && cycle) send(foreign_command(fault));
    if (fault.kind == DriveFaultKind::duplicate_id && begins) send(boot_up(fault));
    if (fault.kind == DriveFaultKind::duplicate_id && cycle) send(idle_status(fault));
    if (fault.kind == DriveFaultKind::error_passive && begins) send(error_passive());
    if (fault.kind == DriveFaultKind::bus_off && begins) send(error_frame(kErrorBusOff));
    if (fault.kind == DriveFaultKind::flood) flood(fault, dt, send);
  });
}

void BusFaults::flood(const DriveFault& fault, double dt, const FrameSink& send)
{
  const can::Frame frame = data_frame(static_cast<std::uint32_t>(fault.value) & 0x7FF, 8);
  const int bits = can::worst_case_bits(frame);
  for (bits_left_ += bit_rate_ * dt; bits_left_ >= bits; bits_left_ -= bits) send(frame);
}

}  // namespace fourwis::drives
