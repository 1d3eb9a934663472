#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace fourwis
{

/// Runs tasks on one thread of its own, in the order in which they came, of which only the newest matters: submitting
/// one cancels all before it. A cancelled task is called all the same, so that it can say so to the caller that waits for it.
class PlanWorker
{
public:
  /// Returns soon after its argument has become true.
  using Task = std::function<void(const std::atomic<bool>& cancelled)>;
  /// Set it to cancel one task.
  using Ticket = std::shared_ptr<std::atomic<bool>>;

  PlanWorker();
  /// Cancels everything and waits until it has ended.
  ~PlanWorker();
  PlanWorker(const PlanWorker&) = delete;
  PlanWorker& operator=(const PlanWorker&) = delete;

  Ticket submit(Task task);

  /// Cancels what runs and waits; whether there was anything.
  bool cancel();

  /// Whether a task runs or waits.
  bool is_busy() const;

private:
  struct Job
  {
    Task task;
    Ticket cancelled;
  };

  void run();
  bool cancel_locked();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool stopping_ = false;
  std::deque<Job> waiting_;
  Ticket running_;      ///< of the task that runs now, if any
  std::thread thread_;  ///< last: starts when all else is there
};

}  // namespace fourwis
