#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "fourwis_navigation/can/protocol/frame.h"
#include "fourwis_navigation/drives/axis_motion.h"
#include "fourwis_navigation/drives/drive_options.h"
#include "fourwis_navigation/drives/nmt_state.h"
#include "fourwis_navigation/drives/object_dictionary.h"
#include "fourwis_navigation/drives/power_state.h"

namespace fourwis::drives
{

/// A simulated servo drive after CiA 301 and CiA 402. It receives frames, and gives frames and demands for its motor.
/// Like a real drive it follows an old target as soon as it is enabled. Times are in s and never decrease. Not
/// simulated: segmented SDO, RTR, SYNC counters, homing by switches, a memory for settings.
class FakeDrive
{
public:
  /// It begins to boot at time 0.
  explicit FakeDrive(const DriveOptions& options);
  ~FakeDrive();
  FakeDrive(FakeDrive&&) noexcept;
  FakeDrive& operator=(FakeDrive&&) noexcept;

  void receive(double now, const can::Frame& frame);
  /// Advances the time to `now`; `motor` is the motion of the motor at that time.
  void advance(double now, const AxisMotion& motor);

  AxisDemand demand() const;
  /// The frames that were sent since the last call, oldest first.
  std::vector<can::Frame> take_sent();

  // Faults.
  void reboot(double now);            ///< power off and on: all settings are those of the delivery state
  void fail(std::uint16_t code);      ///< fault reaction, then fault, with an emergency
  void warn(std::uint16_t code);      ///< emergency and warning bit until the next fault reset or reboot; it works on
  void shift_encoder(double counts);  ///< the measured position is shifted from now on

  NmtState nmt_state() const;
  PowerState power_state() const;
  const ObjectDictionary& objects() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fourwis::drives
