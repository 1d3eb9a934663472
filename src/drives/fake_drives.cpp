#include "fourwis_navigation/drives/fake_drives.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "bus_faults.h"
#include "bus_port.h"
#include "drive_axis.h"
#include "fault_schedule.h"
#include "fourwis_navigation/model/option_check.h"
#include "line_faults.h"

namespace fourwis::drives
{
namespace
{

/// Whether it is a fault of the bus, not of a node.
bool is_of_the_bus(DriveFaultKind kind)
{
  return kind == DriveFaultKind::flood || kind == DriveFaultKind::error_passive || kind == DriveFaultKind::bus_off;
}

}  // namespace

class FakeDrives::Implementation
{
public:
  Implementation(can::Bus& bus, const Robot& robot, const can::BridgeOptions& bridge, const SimulatorOptions& simulator)
    : port_(bus),
      plant_(checked(robot), simulator.actuators, simulator.slip),
      line_(faults_),
      bus_faults_(faults_, checked(bridge).bit_rate),
      time_step_(checked(simulator).time_step)
  {
    for (int wheel = 0; wheel < kWheels; ++wheel) axes_.push_back(DriveAxis::steering(robot, bridge, wheel));
    for (int wheel = 0; wheel < kWheels; ++wheel) axes_.push_back(DriveAxis::driving(robot, bridge, wheel));
  }

  void step()
  {
    ++steps_;
    faults_.advance(time());
    begin_faults();
    receive();
    bus_faults_.step(time(), time_step_, [this](const can::Frame& frame) { send_to_all(frame); });
    for (DriveAxis& axis : axes_) axis.measure(plant_, time(), time_step_);
    send();
    for (DriveAxis& axis : axes_) actuate(axis);
    plant_.step(time_step_);
  }

  void advance(double duration)
  {
    remainder_ += duration;
    for (; remainder_ >= time_step_ * (1.0 - 1e-6); remainder_ -= time_step_) step();
  }

  double time() const { return static_cast<double>(steps_) * time_step_; }
  Plant& plant() { return plant_; }

  DriveAxis& axis(int node)
  {
    const auto found = std::find_if(axes_.begin(), axes_.end(), [&](const DriveAxis& a) { return a.node() == node; });
    if (found == axes_.end()) throw std::out_of_range("no drive has the node id " + std::to_string(node));
    return *found;
  }

  void inject(const DriveFault& fault)
  {
    if (!is_of_the_bus(fault.kind)) axis(fault.node);
    faults_.add(fault);
  }

  void clear_faults() { faults_.clear(); }

private:
  /// Begins the faults that happen once within a drive.
  void begin_faults()
  {
    faults_.for_each_active([this](const DriveFault& fault, bool begins) {
      if (!begins || is_of_the_bus(fault.kind)) return;
      FakeDrive& drive = axis(fault.node).drive();
      const auto code = static_cast<std::uint16_t>(fault.value);
      if (fault.kind == DriveFaultKind::reboot) drive.reboot(time());
      if (fault.kind == DriveFaultKind::emergency) drive.warn(code);
      if (fault.kind == DriveFaultKind::drive_fault) drive.fail(code);
      if (fault.kind == DriveFaultKind::encoder_jump) drive.shift_encoder(static_cast<double>(fault.value));
    });
  }

  void receive()
  {
    for (can::Frame frame; port_.receive(frame);) deliver(frame);
  }

  void deliver(const can::Frame& frame)
  {
    for (DriveAxis& axis : axes_)
    {
      if (const auto reply = line_.abort_reply(axis.node(), frame)) port_.send(*reply);
      if (line_.receives(axis.node(), frame)) axis.drive().receive(time(), frame);
    }
  }

  /// The drives also receive frames of nodes that share their end of the bus.
  void send_to_all(const can::Frame& frame)
  {
    port_.send(frame);
    deliver(frame);
  }

  void send()
  {
    for (DriveAxis& axis : axes_)
      for (const can::Frame& frame : axis.drive().take_sent())
        if (const auto passed = line_.passes(axis.node(), frame)) port_.send(*passed);
    port_.flush();
  }

  void actuate(DriveAxis& axis)
  {
    const bool stuck = faults_.active(DriveFaultKind::stuck_axis, axis.node()) != nullptr;
    const bool dead = faults_.active(DriveFaultKind::dead_axis, axis.node()) != nullptr;
    axis.actuate(plant_, time_step_, stuck, dead);
  }

  BusPort port_;
  Plant plant_;
  FaultSchedule faults_;
  LineFaults line_;
  BusFaults bus_faults_;
  double time_step_;
  std::vector<DriveAxis> axes_;
  std::int64_t steps_ = 0;
  double remainder_ = 0.0;
};

FakeDrives::FakeDrives(can::Bus& bus, const Robot& robot, const can::BridgeOptions& bridge,
                       const SimulatorOptions& simulator)
  : implementation_(std::make_unique<Implementation>(bus, robot, bridge, simulator))
{}

FakeDrives::~FakeDrives() = default;

void FakeDrives::place(const Pose& pose)
{
  implementation_->plant().place(pose);
}
void FakeDrives::step()
{
  implementation_->step();
}
void FakeDrives::advance(double duration)
{
  implementation_->advance(duration);
}
double FakeDrives::time() const
{
  return implementation_->time();
}
const Pose& FakeDrives::pose() const
{
  return implementation_->plant().body().pose();
}
const Twist& FakeDrives::twist() const
{
  return implementation_->plant().body().twist();
}
WheelMotion FakeDrives::truth() const
{
  return implementation_->plant().wheels();
}
const FakeDrive& FakeDrives::drive(int node) const
{
  return implementation_->axis(node).drive();
}
void FakeDrives::inject(const DriveFault& fault)
{
  implementation_->inject(fault);
}
void FakeDrives::clear_faults()
{
  implementation_->clear_faults();
}

}  // namespace fourwis::drives
