#pragma once

#include "fourwis_navigation/can/bus/outbox.h"
#include "sdo_script.h"

namespace fourwis::can
{

/// Carries out a script with one drive, one request at a time. A request without an answer is sent up to three times.
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

  /// `script` must exist until the client is done or stopped.
  void start(const SdoScript& script, double now, Outbox& outbox);
  void stop() { state_ = State::idle; }

  void receive(const Frame& frame, double now, Outbox& outbox);

  /// Once a cycle: repeats a request that was not answered in time, or fails after the last attempt.
  void supervise(double now, Outbox& outbox);

  State state() const { return state_; }
  Fault fault() const { return fault_; }            ///< of `failed`
  std::uint32_t detail() const { return detail_; }  ///< abort code, or the value that was read
  std::uint32_t object() const;                     ///< the object of the present step, index << 8 | sub-index

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
  bool reading_ = false;  ///< whether the pending request is a read
  int attempts_ = 0;
  double asked_ = 0.0;
  State state_ = State::idle;
  Fault fault_ = Fault::count;
  std::uint32_t detail_ = 0;
};

}  // namespace fourwis::can
