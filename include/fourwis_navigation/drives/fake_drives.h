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

/// A base without mass whose wheels are turned by eight CiA 402 drives at one end of a CAN bus: frames in, motion,
/// frames out. The same mechanics as BaseSimulator's, without its electronics: what the base is to do by itself is the
/// master's business. Repeatable: the same frames at the same steps give the same frames and the same motion, bit for
/// bit.
class FakeDrives
{
public:
  /// Of `bridge` what the drives are: nodes, counts, wheel radius, identity, bit rate. The bus must outlive this.
  /// Throws std::invalid_argument naming the option, its value and the range.
  FakeDrives(can::Bus& bus, const Robot& robot, const can::BridgeOptions& bridge, const SimulatorOptions& simulator);
  ~FakeDrives();

  /// Puts the robot there, at rest; wheels keep their angles.
  void place(const Pose& pose);

  /// One time step: what has come is obeyed, everything moves, what the drives say is sent.
  void step();
  /// As many of them as there are in `duration` [s]; what remains is kept for the next call.
  void advance(double duration);

  double time() const;         ///< since the beginning, of the drives' clock [s]
  const Pose& pose() const;    ///< where the body really is; theta is not wrapped
  const Twist& twist() const;  ///< how it really moves, in its own frame
  WheelMotion truth() const;   ///< what the wheels really do

  /// The drive with this node id. Throws std::out_of_range where there is none.
  const FakeDrive& drive(int node) const;

  /// From `fault.begin` on. Throws std::out_of_range for a node that does not exist, where it matters.
  void inject(const DriveFault& fault);
  /// Takes all of them back; what a drive has done because of them remains.
  void clear_faults();

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fourwis::drives
