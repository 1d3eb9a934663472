#pragma once

#include <cstdint>
#include <memory>

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/bus/bus.h"
#include "fourwis_navigation/drives/drive_fault.h"
#include "fourwis_navigation/drives/fake_drive.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/sim/simulator_options.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis::drives
{

/// A base without mass whose wheels are turned by eight CiA 402 drives at one end of a CAN bus. It has the mechanics of
/// BaseSimulator without its electronics: the master on the bus has to do what that base does by itself. Repeatable:
/// the same frames at the same steps give the same frames and the same motion, bit for bit.
class FakeDrives
{
public:
  /// `bridge` describes the drives: nodes, counts, wheel radius, identity, bit rate; its other options are ignored. The
  /// bus must outlive this. Throws as the checks of robot and options do.
  FakeDrives(can::Bus& bus, const Robot& robot, const can::BridgeOptions& bridge, const SimulatorOptions& simulator);
  ~FakeDrives();

  /// Places the robot at a pose, at rest. The wheels keep their angles.
  void place(const Pose& pose);

  /// One time step: received frames are obeyed, the base moves, the frames of the drives are sent.
  void step();
  /// As many time steps as there are in `duration` [s]. The remainder is kept for the next call.
  void advance(double duration);

  double time() const;         ///< since the beginning, of the drives' clock [s]
  const Pose& pose() const;    ///< where the body really is; theta is not wrapped
  const Twist& twist() const;  ///< how it really moves, in its own frame
  WheelMotion truth() const;   ///< what the wheels really do

  /// The drive with this node id. Throws std::out_of_range if there is none.
  const FakeDrive& drive(int node) const;

  /// Injects a fault from `fault.begin` on. Throws std::out_of_range for a fault of a node that does not exist.
  void inject(const DriveFault& fault);
  /// Ends all faults. The states that drives have reached because of them remain.
  void clear_faults();

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fourwis::drives
