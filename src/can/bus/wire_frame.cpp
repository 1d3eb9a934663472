#include "wire_frame.h"

#include <algorithm>

namespace fourwis::can
{

can_frame to_wire(const Frame& frame)
{
  can_frame wire{};
  wire.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0) | (frame.remote ? CAN_RTR_FLAG : 0) |
                (frame.error ? CAN_ERR_FLAG : 0);
  wire.can_dlc = frame.size;
  std::copy_n(frame.data.begin(), frame.size, wire.data);
  return wire;
}

bool from_wire(const can_frame& wire, Frame& frame)
{
  Frame read;
  read.id = wire.can_id & CAN_EFF_MASK;
  read.extended = (wire.can_id & CAN_EFF_FLAG) != 0;
  read.remote = (wire.can_id & CAN_RTR_FLAG) != 0;
  read.error = (wire.can_id & CAN_ERR_FLAG) != 0;
  read.size = wire.can_dlc;
  if (!is_valid(read)) return false;
  std::copy_n(wire.data, read.size, read.data.begin());
  frame = read;
  return true;
}

}  // namespace fourwis::can
