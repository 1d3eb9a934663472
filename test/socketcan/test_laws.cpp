#include "../can/bus/bus_laws.h"
#include "vcan_rig.h"

namespace fourwis::can
{
namespace
{

INSTANTIATE_TYPED_TEST_SUITE_P(SocketCan, BusLaws, VcanRig);

}  // namespace
}  // namespace fourwis::can
