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

/// A servo drive after CiA 301 and CiA 402: frames in, what it asks of its motor and frames out. As a real one it does
/// what it is told: a target left over from earlier moves the motor as soon as it is enabled. Times in s, never going
/// back. Not simulated: segmented SDO, RTR, SYNC counters, homing by switches, a memory for settings.
class FakeDrive
{
public:
  /// Boots from 0 on.
  explicit FakeDrive(const DriveOptions& options);
  ~FakeDrive();
  FakeDrive(FakeDrive&&) noexcept;
  FakeDrive& operator=(FakeDrive&&) noexcept;

  void receive(double now, const can::Frame& frame);
  /// Lets time pass until `now`; `motor` is what the motor does then.
  void advance(double now, const AxisMotion& motor);

  AxisDemand demand() const;
  /// What was sent since the last call, oldest first.
  std::vector<can::Frame> take_sent();

  // What can go wrong with it.
  void reboot(double now);            ///< as if power had gone and come: nothing that was written remains
  void fail(std::uint16_t code);      ///< fault reaction, then fault, with an emergency
  void warn(std::uint16_t code);      ///< emergency and warning bit, works on; until the next fault reset or reboot
  void shift_encoder(double counts);  ///< counts differently from here on

  NmtState nmt_state() const;
  PowerState power_state() const;
  const ObjectDictionary& objects() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fourwis::drives
