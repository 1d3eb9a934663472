#pragma once

#include <memory>

#include "command.h"
#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{

/// The interface vcan0. Its state is restored at the end.
class VcanRig
{
public:
  ~VcanRig() { bring_up(); }

  std::unique_ptr<Bus> open() { return open_bus("vcan0"); }
  void take_down() { run("ip link set vcan0 down"); }
  void bring_up() { run("ip link set vcan0 up"); }
  void remove() { run("ip link delete vcan0"); }
  void add() { run("ip link add vcan0 type vcan && ip link set vcan0 up"); }
};

}  // namespace fourwis::can
