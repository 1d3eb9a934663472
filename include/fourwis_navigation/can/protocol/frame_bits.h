#pragma once

#include "fourwis_navigation/can/protocol/frame.h"

namespace fourwis::can
{

/// Bits that a frame takes on the bus at most, stuff bits and the gap to the next frame included: 47 + 8 n +
/// floor((34 + 8 n - 1) / 4) for n bytes of data (Davis et al., Controller Area Network schedulability analysis, 2007);
/// 20 more bits of header, all of them stuffed, for an extended id.
inline int worst_case_bits(const Frame& frame)
{
  const int data = frame.remote ? 0 : 8 * frame.size;
  const int header = frame.extended ? 20 : 0;
  return 47 + header + data + (34 + header + data - 1) / 4;
}

}  // namespace fourwis::can
