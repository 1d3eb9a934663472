#include "ros/bridge_diagnostics.h"

#include <gtest/gtest.h>

namespace fourwis
{
namespace
{

using can::BridgeStage;

can::BridgeReport report(BridgeStage stage, const can::FaultRecord& cause = {})
{
  can::BridgeReport report;
  report.stage = stage;
  report.cause = cause;
  return report;
}

TEST(Explanation, SaysWhyTheBaseDoesNotDriveAndNothingWhileItDoes)
{
  EXPECT_EQ(explanation(report(BridgeStage::enabled)), "");
  EXPECT_EQ(explanation(report(BridgeStage::enabled, {can::Fault::error_passive})), "");
  EXPECT_EQ(explanation(report(BridgeStage::configure)), "configure");
  EXPECT_EQ(explanation(report(BridgeStage::ready)), "not enabled");
  EXPECT_EQ(explanation(report(BridgeStage::ready, {can::Fault::command_timeout})),
            "not enabled: base: command_timeout");
  EXPECT_EQ(explanation(report(BridgeStage::fault, {can::Fault::heartbeat_lost, 2})),
            "fault: steering rear_left: heartbeat_lost");
}

TEST(Explanation, SaysThatTheEmergencyStopIsPressed)
{
  can::BridgeReport pressed = report(BridgeStage::ready, {can::Fault::emergency_stop});
  pressed.emergency_stop = true;
  EXPECT_EQ(explanation(pressed), "not enabled, emergency stop pressed: base: emergency_stop");
}

}  // namespace
}  // namespace fourwis
