#include "fourwis_navigation/drives/fake_drive.h"

#include <optional>
#include <utility>

#include "communication.h"
#include "errors.h"
#include "fourwis_navigation/model/option_check.h"
#include "pdo_rules.h"
#include "power_stage.h"

namespace fourwis::drives
{

void check(const DriveOptions& options)
{
  check_ranges(options);
}

class FakeDrive::Implementation
{
public:
  explicit Implementation(const DriveOptions& options) : options_(checked(options)), dictionary_(drive_objects(options))
  {
    dictionary_.add_rule(pdo_abort_code);
    dictionary_.listen([this](ObjectAddress address) { written(address); });
    reboot(0.0);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void receive(double now, const can::Frame& frame)
  {
    react(now, communication_->receive(now, frame));
    power_->publish();
  }

  void advance(double now, const AxisMotion& motor)
  {
    const double dt = now - std::exchange(time_, now);
    if (dt <= 0.0) return;
    boot_when_due(now);
    if (power_->advance(dt, motor)) fail(kFollowingErrorCode);
    react(now, communication_->watch(now));
    power_->publish();
    communication_->publish(now);
  }

  void fail(std::uint16_t code)
  {
    power_->fail();
    communication_->raise(code);
    power_->publish();
  }

  void warn(std::uint16_t code)
  {
    power_->set_warning(true);
    communication_->raise(code);
    power_->publish();
  }

  void reboot(double now)
  {
    power_.emplace(dictionary_, options_.max_velocity);
    restart(now, 0x0000, 0xFFFF);
    power_->publish();
  }

  void shift_encoder(double counts) { power_->shift_encoder(counts); }

  AxisDemand demand() const { return power_->demand(); }
  std::vector<can::Frame> take_sent() { return std::exchange(sent_, {}); }
  NmtState nmt_state() const { return communication_->state(); }
  PowerState power_state() const { return power_->state(); }
  const ObjectDictionary& objects() const { return dictionary_; }

private:
  void react(double now, CommunicationEvent event)
  {
    switch (event)
    {
      case CommunicationEvent::none: return;
      case CommunicationEvent::connection_lost: power_->lose_connection(); return;
      case CommunicationEvent::reset_node: reboot(now); return;
      case CommunicationEvent::reset_communication: power_->lose_connection(); restart(now, 0x1000, 0x1FFF);
    }
  }

  /// Sets the objects from `first` to `last` to the delivery state, and boots the node.
  void restart(double now, std::uint16_t first, std::uint16_t last)
  {
    dictionary_.restore(drive_objects(options_), first, last);
    communication_.emplace(dictionary_, options_.node, [this](const can::Frame& frame) { sent_.push_back(frame); });
    boots_at_ = now + options_.boot_time;
  }

  void boot_when_due(double now)
  {
    const bool booted = communication_->state() != NmtState::initialising;
    if (!booted && now >= boots_at_ - kTimeRounding) communication_->boot();
    const bool tested = now >= boots_at_ + options_.self_test_time - kTimeRounding;
    if (power_->state() == PowerState::not_ready && tested) power_->become_ready();
  }

  void written(ObjectAddress address)
  {
    power_->written(address);
    if (address.index == object::kControlword && is_reset()) clear_errors();
    if (address.index == object::kErrorHistory)
      for (std::uint8_t k = 1; k <= kErrorsKept; ++k) dictionary_.set({object::kErrorHistory, k}, 0);
  }

  /// Whether the controlword resets faults, no fault is left, and an error is still recorded.
  bool is_reset() const
  {
    const bool asked = (dictionary_.get(object::kControlword) & 0x80) != 0;
    const bool works = power_->state() != PowerState::fault && power_->state() != PowerState::fault_reaction;
    return asked && works && dictionary_.get(object::kErrorRegister) != 0;
  }

  void clear_errors()
  {
    power_->set_warning(false);
    communication_->clear();
  }

  DriveOptions options_;
  ObjectDictionary dictionary_;
  std::vector<can::Frame> sent_;
  std::optional<Communication> communication_;
  std::optional<PowerStage> power_;
  double time_ = 0.0, boots_at_ = 0.0;
};

FakeDrive::FakeDrive(const DriveOptions& options) : implementation_(std::make_unique<Implementation>(options)) {}
FakeDrive::~FakeDrive() = default;
FakeDrive::FakeDrive(FakeDrive&&) noexcept = default;
FakeDrive& FakeDrive::operator=(FakeDrive&&) noexcept = default;

void FakeDrive::receive(double now, const can::Frame& frame)
{
  implementation_->receive(now, frame);
}
void FakeDrive::advance(double now, const AxisMotion& motor)
{
  implementation_->advance(now, motor);
}
AxisDemand FakeDrive::demand() const
{
  return implementation_->demand();
}
std::vector<can::Frame> FakeDrive::take_sent()
{
  return implementation_->take_sent();
}
void FakeDrive::reboot(double now)
{
  implementation_->reboot(now);
}
void FakeDrive::fail(std::uint16_t code)
{
  implementation_->fail(code);
}
void FakeDrive::warn(std::uint16_t code)
{
  implementation_->warn(code);
}
void FakeDrive::shift_encoder(double counts)
{
  implementation_->shift_encoder(counts);
}
NmtState FakeDrive::nmt_state() const
{
  return implementation_->nmt_state();
}
PowerState FakeDrive::power_state() const
{
  return implementation_->power_state();
}
const ObjectDictionary& FakeDrive::objects() const
{
  return implementation_->objects();
}

}  // namespace fourwis::drives
