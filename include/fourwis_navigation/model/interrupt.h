#pragma once

#include <atomic>
#include <chrono>

namespace fourwis
{

/// Why planning should stop before it is done; polled every few dozen microseconds by every stage.
class Interrupt
{
public:
  using Clock = std::chrono::steady_clock;

  Interrupt() = default;
  /// `cancelled` (may be null) is watched, not owned; `deadline` is a wall-clock limit.
  explicit Interrupt(const std::atomic<bool>* cancelled, Clock::time_point deadline = Clock::time_point::max())
    : cancelled_(cancelled),
      deadline_(deadline)
  {}

  /// The same, and a deadline `seconds` from now if that is earlier.
  Interrupt or_after(double seconds) const
  {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> left = deadline_ - now;
    if (left.count() <= seconds) return *this;
    return Interrupt(cancelled_,
                     now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
  }

  bool cancelled() const { return cancelled_ && cancelled_->load(std::memory_order_relaxed); }
  bool timed_out() const { return deadline_ != Clock::time_point::max() && Clock::now() >= deadline_; }

private:
  const std::atomic<bool>* cancelled_ = nullptr;
  Clock::time_point deadline_ = Clock::time_point::max();
};

}  // namespace fourwis
