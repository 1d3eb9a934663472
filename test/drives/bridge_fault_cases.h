#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <ostream>
#include <vector>

#include "bridge_bench.h"

namespace fourwis
{

/// A fault of a base that drives straight ahead at 0.5 m/s, the name that the bridge must give it, and the time after
/// which the bridge must not command any wheel to move.
struct FaultCase
{
  drives::DriveFaultKind kind;
  int node;
  std::int64_t value;
  can::Fault name;
  double deadline;  ///< [s]
};

inline std::ostream& operator<<(std::ostream& out, const FaultCase& c)
{
  return out << to_string(c.kind) << " at node " << c.node;
}

/// A message is received within a step of the simulation. What is checked once a cycle is detected a cycle later. Stop
/// frames follow within 10 ms of the detection.
constexpr double kAtOnce = 0.002, kCycle = 0.01;

inline const std::vector<FaultCase> kFaultCases = {
    // A drive that is silent: five SYNC without an answer. Its heartbeat would be missed after 150 ms.
    {drives::DriveFaultKind::node_silent, 6, 0, can::Fault::feedback_lost, 0.06 + kCycle},
    {drives::DriveFaultKind::node_silent, 2, 0, can::Fault::feedback_lost, 0.06 + kCycle},
    {drives::DriveFaultKind::heartbeat_lost, 3, 0, can::Fault::heartbeat_lost, 0.15 + kCycle},
    {drives::DriveFaultKind::heartbeat_lost, 8, 0, can::Fault::heartbeat_lost, 0.15 + kCycle},
    // It boots 100 ms later, but is silent from the beginning.
    {drives::DriveFaultKind::reboot, 6, 0, can::Fault::feedback_lost, 0.06 + kCycle},
    {drives::DriveFaultKind::reboot, 1, 0, can::Fault::node_rebooted, 0.06 + kCycle},
    {drives::DriveFaultKind::emergency, 7, 0x4210, can::Fault::emergency_message, kAtOnce},
    {drives::DriveFaultKind::emergency, 1, 0x7305, can::Fault::emergency_message, kAtOnce},
    {drives::DriveFaultKind::drive_fault, 7, 0x2310, can::Fault::drive_fault, kAtOnce},
    {drives::DriveFaultKind::drive_fault, 4, 0x2310, can::Fault::emergency_message, kAtOnce},
    {drives::DriveFaultKind::wrong_size, 3, 0, can::Fault::malformed_frame, kCycle + kAtOnce},
    {drives::DriveFaultKind::wrong_size, 5, 0, can::Fault::malformed_frame, kCycle + kAtOnce},
    // The second node boots, and the drive with the same id still answers.
    {drives::DriveFaultKind::duplicate_id, 4, 0, can::Fault::duplicate_node, kCycle + kAtOnce},
    {drives::DriveFaultKind::duplicate_id, 7, 0, can::Fault::duplicate_node, kCycle + kAtOnce},
    {drives::DriveFaultKind::status_missing, 5, 0, can::Fault::feedback_lost, 0.06 + kCycle},
    // After 0.03 s the wheel is slower by more than 0.3 m/s, and then for 0.3 s.
    {drives::DriveFaultKind::stuck_axis, 7, 0, can::Fault::speed_not_followed, 0.03 + 0.3 + 2 * kCycle},
    {drives::DriveFaultKind::encoder_jump, 2, 600000, can::Fault::encoder_jump, kCycle + kAtOnce},
    {drives::DriveFaultKind::encoder_jump, 6, -1000000, can::Fault::encoder_jump, kCycle + kAtOnce},
    {drives::DriveFaultKind::foreign_master, 8, 100000, can::Fault::foreign_master, kCycle + kAtOnce},
    {drives::DriveFaultKind::foreign_master, 1, 0, can::Fault::foreign_master, kCycle + kAtOnce},
    {drives::DriveFaultKind::bus_off, 0, 0, can::Fault::bus_off, kAtOnce},
};

/// The base stops in time, and the fault has its name.
inline void expect_stop(BridgeBench& bench, const FaultCase& fault)
{
  bench.drive();
  const double begin = bench.now() + 0.001;
  bench.drives.inject({fault.kind, fault.node, begin, std::numeric_limits<double>::infinity(), fault.value});
  bench.pass(2.0);
  EXPECT_TRUE(bench.told(fault.name)) << bench.cause();
  EXPECT_LE(bench.last_motion() - begin, fault.deadline) << bench.cause();
  EXPECT_NE(bench.stage(), can::BridgeStage::enabled);

  // It does not start by itself when all is well again and commands still come.
  const double later = bench.now();
  bench.drives.clear_faults();
  bench.pass(1.0);
  EXPECT_LT(bench.last_motion(), later);
  EXPECT_NE(bench.stage(), can::BridgeStage::enabled);
}

}  // namespace fourwis
