#include <ostream>
#include <vector>

#include "bridge_fixture.h"

namespace fourwis
{
namespace
{

using can::BridgeStage;
using can::Fault;
using sim::DriveFaultKind;

/// What goes wrong with a base that drives straight ahead at 0.5 m/s, the name that it must get, and the time after
/// which the bridge must not tell any wheel to move any more.
struct FaultCase
{
  DriveFaultKind kind;
  int node;
  std::int64_t value;
  Fault name;
  double deadline;  ///< [s]
};

std::ostream& operator<<(std::ostream& out, const FaultCase& c)
{
  return out << to_string(c.kind) << " at node " << c.node;
}

/// A message counts as received within a step of the simulation; what is looked for once a cycle, a cycle later. Stop
/// frames follow within 10 ms of detection.
constexpr double kAtOnce = 0.002, kCycle = 0.01;

const std::vector<FaultCase> kCases = {
  // A drive that is silent: five SYNC without an answer. Its heartbeat would be missed after 150 ms.
  {DriveFaultKind::node_silent, 6, 0, Fault::feedback_lost, 0.06 + kCycle},
  {DriveFaultKind::node_silent, 2, 0, Fault::feedback_lost, 0.06 + kCycle},
  {DriveFaultKind::heartbeat_lost, 3, 0, Fault::heartbeat_lost, 0.15 + kCycle},
  {DriveFaultKind::heartbeat_lost, 8, 0, Fault::heartbeat_lost, 0.15 + kCycle},
  // It boots 100 ms later, but is silent from the beginning.
  {DriveFaultKind::reboot, 6, 0, Fault::feedback_lost, 0.06 + kCycle},
  {DriveFaultKind::reboot, 1, 0, Fault::node_rebooted, 0.06 + kCycle},
  {DriveFaultKind::emergency, 7, 0x4210, Fault::emergency_message, kAtOnce},
  {DriveFaultKind::emergency, 1, 0x7305, Fault::emergency_message, kAtOnce},
  {DriveFaultKind::drive_fault, 7, 0x2310, Fault::drive_fault, kAtOnce},
  {DriveFaultKind::drive_fault, 4, 0x2310, Fault::emergency_message, kAtOnce},
  {DriveFaultKind::wrong_size, 3, 0, Fault::malformed_frame, kCycle + kAtOnce},
  {DriveFaultKind::wrong_size, 5, 0, Fault::malformed_frame, kCycle + kAtOnce},
  // It boots, and the drive it pretends to be answers all the same.
  {DriveFaultKind::duplicate_id, 4, 0, Fault::duplicate_node, kCycle + kAtOnce},
  {DriveFaultKind::duplicate_id, 7, 0, Fault::duplicate_node, kCycle + kAtOnce},
  {DriveFaultKind::status_missing, 5, 0, Fault::feedback_lost, 0.06 + kCycle},
  // After 0.03 s the wheel is slower by more than 0.3 m/s, and then for 0.3 s.
  {DriveFaultKind::stuck_axis, 7, 0, Fault::speed_not_followed, 0.03 + 0.3 + 2 * kCycle},
  {DriveFaultKind::encoder_jump, 2, 600000, Fault::encoder_jump, kCycle + kAtOnce},
  {DriveFaultKind::encoder_jump, 6, -1000000, Fault::encoder_jump, kCycle + kAtOnce},
  {DriveFaultKind::foreign_master, 8, 100000, Fault::foreign_master, kCycle + kAtOnce},
  {DriveFaultKind::foreign_master, 1, 0, Fault::foreign_master, kCycle + kAtOnce},
  {DriveFaultKind::bus_off, 0, 0, Fault::bus_off, kAtOnce},
};

class BridgeFaults : public BridgeFixture, public testing::WithParamInterface<FaultCase>
{
};

TEST_P(BridgeFaults, StopTheBaseInTimeAndHaveTheirName)
{
  const FaultCase& fault = GetParam();
  drive();
  const double begin = now() + 0.001;
  drives.inject({fault.kind, fault.node, begin, std::numeric_limits<double>::infinity(), fault.value});
  pass(2.0);
  EXPECT_TRUE(told(fault.name)) << cause();
  EXPECT_LE(last_motion() - begin, fault.deadline) << cause();
  EXPECT_NE(stage(), BridgeStage::enabled);

  // It does not start by itself when all is well again and commands still come.
  const double later = now();
  drives.clear_faults();
  pass(1.0);
  EXPECT_LT(last_motion(), later);
  EXPECT_NE(stage(), BridgeStage::enabled);
}

INSTANTIATE_TEST_SUITE_P(All, BridgeFaults, testing::ValuesIn(kCases));

}  // namespace
}  // namespace fourwis
