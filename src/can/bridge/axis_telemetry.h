#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/bus/outbox.h"
#include "fourwis_navigation/can/protocol/sdo.h"

namespace fourwis::can
{

/// Reads from a drive in operation, once a second, what control does not need: its supply voltage (6079) and, if the
/// options name an object for it, its temperature. An object that the drive does not have is requested only once.
class AxisTelemetry
{
public:
  AxisTelemetry(const BridgeOptions& options, int node);

  void begin(double now);
  void supervise(double now, Outbox& outbox);
  void receive(const Frame& frame);

  double voltage() const { return items_[0].value; }      ///< NaN where it is not known [V]
  double temperature() const { return items_[1].value; }  ///< likewise [deg C]

private:
  struct Item
  {
    ObjectId object;  ///< index 0: there is none
    double unit = 1.0;
    double value = std::numeric_limits<double>::quiet_NaN();
  };

  int node_;
  std::array<Item, 2> items_;
  std::size_t turn_ = 0;
  double next_ = 0.0;
};

}  // namespace fourwis::can
