#pragma once

#include <atomic>
#include <mutex>
#include <string>

#include "fourwis_navigation/can/bus/signal_event.h"

namespace fourwis::can
{

/// What people ask of a thread that must not wait for them: they do.
class RequestSlot
{
public:
  enum class Request
  {
    none,
    enable,
    disable,
    clear_faults
  };

  /// `wake`: told when there is a request. `patience`: a request that was not taken after so long is withdrawn [s].
  explicit RequestSlot(SignalEvent& wake, double patience = 1.0) : wake_(wake), patience_(patience) {}

  /// Asks, and waits for the answer; empty when it is accepted.
  std::string ask(Request request)
  {
    const std::lock_guard<std::mutex> one_at_a_time(mutex_);
    answered_.clear();
    request_.store(request);
    wake_.raise();
    bool answered = answered_.wait(patience_);
    const bool withdrawn = !answered && request_.exchange(Request::none) != Request::none;
    if (withdrawn) return "the bridge does not answer";
    // Or else it has been taken, and the answer is on its way.
    while (!answered) answered = answered_.wait(patience_);
    const char* refusal = answer_.load();
    return refusal ? refusal : "";
  }

  /// In the thread that is asked: the request that waits, or none.
  Request take() { return request_.exchange(Request::none); }

  /// Likewise: the answer, null when it is accepted.
  void answer(const char* refusal)
  {
    answer_.store(refusal);
    answered_.raise();
  }

private:
  SignalEvent& wake_;
  const double patience_;
  SignalEvent answered_;
  std::mutex mutex_;
  std::atomic<Request> request_{Request::none};
  std::atomic<const char*> answer_{nullptr};
};

}  // namespace fourwis::can
