#include "make_protocol.h"

#include "cia402_base.h"
#include "ranger_base.h"

namespace fourwis::can
{

std::unique_ptr<BaseProtocol> make_protocol(const Robot& robot, const BridgeOptions& options, FaultLog& log)
{
  if (options.protocol == Protocol::ranger) return std::make_unique<RangerBase>(robot, options, log);
  return std::make_unique<Cia402Base>(robot, options, log);
}

}  // namespace fourwis::can
