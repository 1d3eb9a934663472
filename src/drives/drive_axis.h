#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/drives/fake_drive.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/sim/plant.h"

namespace fourwis::drives
{

/// A drive and the axis of the base that its motor turns.
class DriveAxis
{
public:
  static DriveAxis steering(const Robot& robot, const can::BridgeOptions& options, int wheel);
  static DriveAxis driving(const Robot& robot, const can::BridgeOptions& options, int wheel);

  int node() const { return node_; }
  FakeDrive& drive() { return drive_; }
  const FakeDrive& drive() const { return drive_; }

  /// Gives the drive the motion of its motor in the step of `dt` [s] that ends at `now`.
  void measure(const Plant& plant, double now, double dt);
  /// Moves the axis as the drive demands for the next `dt` [s]. `stuck`: it does not move; `dead`: it has no torque.
  void actuate(Plant& plant, double dt, bool stuck, bool dead);

private:
  DriveAxis(const can::AxisOptions& axis, double counts_per_unit, int wheel, bool steers, const DriveOptions& drive);

  void steer(Plant& plant, const AxisDemand& demand, double dt, bool powered);
  void roll(Plant& plant, const AxisDemand& demand, bool stuck, bool powered);

  int node_, wheel_;
  bool steers_;
  double counts_per_unit_;  ///< count/rad where it steers, count/m where it drives; negative where it is reversed
  double offset_;           ///< position at count 0 [rad or m]
  FakeDrive drive_;
  AxisMotion motor_;
  double position_ = 0.0;   ///< [rad] or rolled [m]
  double reference_ = 0.0;  ///< target angle of a steering axis; integrated if a velocity is demanded [rad]
};

}  // namespace fourwis::drives
