#include "bridge_state.h"

namespace fourwis::can
{
namespace
{

BridgeStage starting_stage(StartStep step)
{
  switch (step)
  {
    case StartStep::listening: return BridgeStage::listening;
    case StartStep::booting: return BridgeStage::boot;
    case StartStep::identifying: return BridgeStage::identify;
    case StartStep::configuring: return BridgeStage::configure;
    case StartStep::homing: return BridgeStage::home;
    case StartStep::starting:
    case StartStep::started: break;
  }
  return BridgeStage::start;
}

}  // namespace

BaseState base_state(BridgeState state)
{
  switch (state)
  {
    case BridgeState::waiting:
    case BridgeState::starting: return BaseState::not_ready;
    case BridgeState::ready:
    case BridgeState::enabling: return BaseState::ready;
    case BridgeState::enabled: return BaseState::enabled;
    case BridgeState::stopping: return BaseState::stopping;
    case BridgeState::fault: return BaseState::fault;
  }
  return BaseState::fault;
}

BridgeStage bridge_stage(BridgeState state, StartStep step)
{
  switch (state)
  {
    case BridgeState::waiting: return BridgeStage::link_down;
    case BridgeState::starting: return starting_stage(step);
    case BridgeState::ready: return BridgeStage::ready;
    case BridgeState::enabling: return step == StartStep::homing ? BridgeStage::home : BridgeStage::enabling;
    case BridgeState::enabled: return BridgeStage::enabled;
    case BridgeState::stopping: return BridgeStage::stopping;
    case BridgeState::fault: break;
  }
  return BridgeStage::fault;
}

const char* to_string(BridgeStage stage)
{
  switch (stage)
  {
    case BridgeStage::link_down: return "link down";
    case BridgeStage::listening: return "listening";
    case BridgeStage::boot: return "boot";
    case BridgeStage::identify: return "identify";
    case BridgeStage::configure: return "configure";
    case BridgeStage::start: return "start";
    case BridgeStage::home: return "home";
    case BridgeStage::ready: return "ready";
    case BridgeStage::enabling: return "enabling";
    case BridgeStage::enabled: return "enabled";
    case BridgeStage::stopping: return "stopping";
    case BridgeStage::fault: return "fault";
  }
  return "unknown";
}

}  // namespace fourwis::can
