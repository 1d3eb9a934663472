#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <future>
#include <mutex>
#include <vector>

namespace fourwis
{

/// As many as the processors that this process may use.
int hardware_threads();

/// Bounds how many threads work at once, over all loops that share it and however deep they are nested. It begins with
/// one at work: the thread that opens the outermost loop.
class ThreadBudget
{
public:
  using Work = std::function<void(std::size_t)>;

  /// Throws std::invalid_argument unless `threads` is at least 1.
  explicit ThreadBudget(int threads = hardware_threads());
  ThreadBudget(const ThreadBudget&) = delete;
  ThreadBudget& operator=(const ThreadBudget&) = delete;

  /// Calls work(0) to work(count - 1), in the calling thread and in others as far as the budget allows. Returns when
  /// all calls have ended. After a call that throws no others begin, and the exception that a plain loop would throw is
  /// thrown. Do not hold a mutex that other calls may wait for.
  void for_each(std::size_t count, const Work& work);

private:
  struct Loop;
  using Helpers = std::vector<std::future<void>>;

  Helpers run(Loop& loop);
  void add_helper(Loop& loop, Helpers& helpers);
  bool take_spare();
  void take();
  void give_back();

  std::mutex mutex_;
  std::condition_variable given_back_;
  int spare_;        ///< how many more threads may work
  int waiting_ = 0;  ///< callers whose helpers have ended; they come before new helpers
};

}  // namespace fourwis
