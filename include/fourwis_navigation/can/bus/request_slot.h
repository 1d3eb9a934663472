#pragma once

#include <atomic>
#include <mutex>
#include <string>

#include "fourwis_navigation/can/bus/signal_event.h"

namespace fourwis::can
{

/// Hands a request from any thread to one that must not wait. The thread that asks waits for the answer.
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

  /// `wake` is raised when there is a request. A request that was not taken within `patience` [s] is withdrawn.
  explicit RequestSlot(SignalEvent& wake, double patience = 1.0) : wake_(wake), patience_(patience) {}

  /// Makes a request and waits for the answer, which is empty when it is accepted.
  std::string ask(Request request)
  {
    const std::lock_guard<std::mutex> one_at_a_time(mutex_);
    answered_.clear();
    request_.store(request);
    wake_.raise();
    bool answered = answered_.wait(patience_);
    const bool withdrawn = !answered && request_.exchange(Request::none) != Request::none;
    if (withdrawn) return "the bridge does not answer";
    // Otherwise it has been taken, and the answer will come.
    while (!answered) answered = answered_.wait(patience_);
    const char* refusal = answer_.load();
    return refusal ? refusal : "";
  }

  /// To be called by the thread that answers: the waiting request, or none.
  Request take() { return request_.exchange(Request::none); }

  /// To be called by the thread that answers; null means that the request is accepted.
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
