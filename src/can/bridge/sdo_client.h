#pragma once

#include "fourwis_navigation/can/bus/outbox.h"
#include "sdo_script.h"

namespace fourwis::can
{

/// Works through a script with one drive, a request at a time, each repeated where no answer comes.
class SdoClient
{
public:
  enum class State
  {
    idle,
    working,
    done,
    failed
  };

  SdoClient(int node, double timeout) : node_(node), timeout_(timeout) {}

  /// `script` must outlive the work.
  void start(const SdoScript& script, double now, Outbox& outbox);
  void stop() { state_ = State::idle; }

  void receive(const Frame& frame, double now, Outbox& outbox);

  /// Repeats the request that was not answered in time.
  void supervise(double now, Outbox& outbox);

  State state() const { return state_; }
  Fault fault() const { return fault_; }            ///< of `failed`
  std::uint32_t detail() const { return detail_; }  ///< abort code, or the value that was read
  std::uint32_t object() const;                     ///< that it failed with, index << 8 | sub-index

private:
  const SdoStep& step() const { return (*script_)[position_]; }
  void request(double now, Outbox& outbox);
  void accept(const SdoReply& reply, double now, Outbox& outbox);
  void advance(double now, Outbox& outbox);
  void fail(Fault fault, std::uint32_t detail);
  bool is_as_wanted(std::uint32_t value) const;

  int node_;
  double timeout_;
  const SdoScript* script_ = nullptr;
  std::size_t position_ = 0;
  bool reading_ = false;  ///< the request that waits for its answer is a read
  int attempts_ = 0;
  double asked_ = 0.0;
  State state_ = State::idle;
  Fault fault_ = Fault::count;
  std::uint32_t detail_ = 0;
};

}  // namespace fourwis::can
