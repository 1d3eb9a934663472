#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "bridge_bench.h"
#include "can/bus/memory_bus.h"

namespace fourwis
{

/// A bus within the test's thread, and its ends.
struct MemoryEnds
{
  explicit MemoryEnds(const can::MemoryBusOptions& options) : bus(options) {}

  can::MemoryBus bus;
  std::unique_ptr<can::MemoryBus::End> end = bus.open(), drives_end = bus.open();
};

/// A BridgeBench on such a bus.
class BridgeFixture : public testing::Test, protected MemoryEnds, protected BridgeBench
{
protected:
  explicit BridgeFixture(const can::BridgeOptions& of_both = {}, const can::MemoryBusOptions& memory = {})
    : BridgeFixture(of_both, of_both, memory)
  {}
  /// The bridge has the options `expected`, the drives have `real`.
  BridgeFixture(const can::BridgeOptions& expected, const can::BridgeOptions& real, const can::MemoryBusOptions& memory)
    : MemoryEnds(memory),
      BridgeBench(
          *end, *drives_end, [this](double now) { bus.advance(now); }, expected, real)
  {}
};

}  // namespace fourwis
