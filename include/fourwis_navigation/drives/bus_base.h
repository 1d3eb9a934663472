#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fourwis_navigation/drives/fake_drives.h"

namespace fourwis::drives
{

/// The base of eight drives behind a bus that others open as well, living in the time of whoever steps it.
class BusBase
{
public:
  /// Of `bus` see can::open_bus(): one that is not there yet, or goes, is looked for at every step. Throws
  /// std::invalid_argument naming the option, its value and the range.
  BusBase(const std::string& bus, const Robot& robot, const can::BridgeOptions& bridge,
          const SimulatorOptions& simulator);

  /// Lets the drives live until `now` [s] of a clock that never goes back; the first call only sets it. More than
  /// kMostCaughtUp is left out: drives whose computer was busy have not been left alone by their master.
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
