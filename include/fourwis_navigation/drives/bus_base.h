#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fourwis_navigation/drives/fake_drives.h"

namespace fourwis::drives
{

/// The base of eight drives at one end of a bus that other processes open as well. The caller advances its time.
class BusBase
{
public:
  /// `bus` is the name for can::open_bus(). A bus that does not exist yet, or is gone, is looked for at every step.
  /// Throws as FakeDrives does.
  BusBase(const std::string& bus, const Robot& robot, const can::BridgeOptions& bridge,
          const SimulatorOptions& simulator);

  /// Advances the drives to `now` [s] of a clock that never goes back. The first call only sets the time. More than
  /// kMostCaughtUp at once is left out: otherwise a delay of this process would count as silence of the master.
  void advance(double now);

  FakeDrives& drives() { return drives_; }
  const can::Bus& bus() const { return *bus_; }

  static constexpr double kMostCaughtUp = 0.02;  ///< [s]

private:
  std::unique_ptr<can::Bus> bus_;
  FakeDrives drives_;
  std::optional<double> time_;  ///< of the last call
};

}  // namespace fourwis::drives
