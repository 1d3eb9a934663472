#include "thread_budget.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{

int hardware_threads()
{
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

struct ThreadBudget::Loop
{
  Loop(std::size_t the_count, const Work& the_work) : count(the_count), work(the_work) {}

  /// Indices are given out in order. If several calls throw, the one with the least index counts, as in a plain loop.
  void failed(std::size_t index)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (!error || index < failed_index)
    {
      error = std::current_exception();
      failed_index = index;
    }
    next = count;
  }

  const std::size_t count;
  const Work& work;
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  std::size_t failed_index = 0;
};

ThreadBudget::ThreadBudget(int threads) : spare_(threads - 1)
{
  if (threads < 1) reject<std::invalid_argument>("threads is ", threads, ", expected 1 or more");
}

void ThreadBudget::for_each(std::size_t count, const Work& work)
{
  Loop loop(count, work);
  Helpers helpers = run(loop);
  if (!helpers.empty())
  {
    // A thread that only waits does not count.
    give_back();
    helpers.clear();
    take();
  }
  if (loop.error) std::rethrow_exception(loop.error);
}

ThreadBudget::Helpers ThreadBudget::run(Loop& loop)
{
  Helpers helpers;
  for (std::size_t i = loop.next++; i < loop.count; i = loop.next++)
  {
    if (loop.next < loop.count) add_helper(loop, helpers);
    try
    {
      loop.work(i);
    }
    catch (...)
    {
      loop.failed(i);
    }
  }
  return helpers;
}

/// One more thread for what is left of the loop, if there is one.
void ThreadBudget::add_helper(Loop& loop, Helpers& helpers)
{
  if (!take_spare()) return;
  try
  {
    // A future of std::async waits in its destructor.
    helpers.push_back(std::async(std::launch::async, [this, &loop] {
      const Helpers further = run(loop);
      give_back();
    }));
  }
  catch (const std::system_error&)
  {
    give_back();  // the system has no more threads
  }
}

bool ThreadBudget::take_spare()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (spare_ <= waiting_) return false;
  --spare_;
  return true;
}

void ThreadBudget::take()
{
  std::unique_lock<std::mutex> lock(mutex_);
  ++waiting_;
  given_back_.wait(lock, [this] { return spare_ > 0; });
  --waiting_;
  --spare_;
}

void ThreadBudget::give_back()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  ++spare_;
  given_back_.notify_one();
}

}  // namespace fourwis
