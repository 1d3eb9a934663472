#include "direct_base_faults.h"

#include "conversions.h"
#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{

DirectBaseFaults::DirectBaseFaults(BaseSimulator& simulator, BaseTopics& base, IdealLocalization& localization)
  : simulator_(simulator),
    base_(base),
    localization_(localization)
{
  using Kind = WheelFault::Kind;
  faults_ = {{"stuck_steering", [this](const auto& fault) { break_wheel(Kind::stuck_steering, fault.wheel); }},
             {"dead_drive", [this](const auto& fault) { break_wheel(Kind::dead_drive, fault.wheel); }},
             {"frozen_encoders", [this](const auto& fault) { break_wheel(Kind::frozen_encoders, fault.wheel); }},
             {"lost_odometry", [this](const auto&) { silent_.odom = true; }},
             {"lost_wheel_states", [this](const auto&) { silent_.wheel_states = true; }},
             {"lost_localization", [this](const auto&) { localization_.set_lost(true); }},
             {"odometry_jump", [this](const auto& fault) {
                jump({fault.x, fault.y, fault.yaw});
              }}};
}

void DirectBaseFaults::inject(const fourwis_navigation::InjectFault::Request& request)
{
  const auto fault = faults_.find(request.kind);
  if (fault == faults_.end())
    reject<ConversionError>("inject_fault: kind is '", request.kind, "', expected one of the service's words");
  fault->second(request);
  base_.set_silence(silent_);
}

void DirectBaseFaults::break_wheel(WheelFault::Kind kind, int wheel)
{
  if (wheel >= kWheels)
    reject<ConversionError>("inject_fault: wheel is ", wheel, ", expected a number from 0 to ", kWheels - 1);
  simulator_.inject({kind, wheel});
}

void DirectBaseFaults::jump(const Pose& by)
{
  if (!is_finite(by))
    reject<ConversionError>("inject_fault: the jump (", by.x, ", ", by.y, ", ", by.theta, ") is not finite");
  const Pose now = base_.odometry();
  base_.set_odometry({now.x + by.x, now.y + by.y, now.theta + by.theta});
}

void DirectBaseFaults::clear()
{
  simulator_.clear_faults();
  localization_.set_lost(false);
  silent_ = {};
  base_.set_silence(silent_);
}

}  // namespace fourwis
