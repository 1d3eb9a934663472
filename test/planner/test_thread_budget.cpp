#include "planner/thread_budget.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace fourwis
{
namespace
{

/// Counts the threads that work at the same time.
class ThreadCounter
{
public:
  /// To be called at work. It takes a while, so that other threads have the time to begin.
  void work()
  {
    note(++working_);
    for (int k = 0; k < 3; ++k)
    {
      std::this_thread::yield();
      note(working_);
    }
    --working_;
  }
  int most() const { return most_; }

private:
  void note(int working)
  {
    int before = most_;
    while (before < working && !most_.compare_exchange_weak(before, working)) continue;
  }

  std::atomic<int> working_{0}, most_{0};
};

TEST(ThreadBudgetTest, CallsEachIndexOnce)
{
  for (int threads : {1, 2, 8})
    for (std::size_t count : {0u, 1u, 2u, 7u, 100u})
    {
      ThreadBudget budget(threads);
      std::vector<std::atomic<int>> calls(count);
      budget.for_each(count, [&](std::size_t i) { ++calls.at(i); });
      for (const std::atomic<int>& times : calls) EXPECT_EQ(times, 1);
    }
}

TEST(ThreadBudgetTest, NeverHasMoreThreadsAtWorkThanItsNumberHoweverDeepLoopsAreNested)
{
  for (int threads : {1, 2, 3, 8})
    for (int repetition = 0; repetition < 5; ++repetition)
    {
      ThreadBudget budget(threads);
      ThreadCounter counter;
      budget.for_each(4, [&](std::size_t i) {
        counter.work();
        budget.for_each(3, [&](std::size_t) {
          counter.work();
          budget.for_each(i, [&](std::size_t) { counter.work(); });
          counter.work();
        });
        counter.work();
      });
      EXPECT_LE(counter.most(), threads);
      EXPECT_GE(counter.most(), 1);
    }
}

TEST(ThreadBudgetTest, HasAsManyThreadsAtWorkAsItMay)
{
  for (int threads : {2, 8})
  {
    ThreadBudget budget(threads);
    std::atomic<int> here{0};
    // Each call waits for all the others.
    budget.for_each(static_cast<std::size_t>(threads), [&](std::size_t) {
      ++here;
      while (here < threads) std::this_thread::yield();
    });
    EXPECT_EQ(here, threads);
  }
}

TEST(ThreadBudgetTest, GivesAnInnerLoopTheThreadsThatTheOuterDoesNotNeed)
{
  constexpr int kThreads = 4;
  ThreadBudget budget(kThreads);
  std::atomic<int> here{0};
  budget.for_each(1, [&](std::size_t) {
    budget.for_each(kThreads, [&](std::size_t) {
      ++here;
      while (here < kThreads) std::this_thread::yield();
    });
  });
  EXPECT_EQ(here, kThreads);
}

TEST(ThreadBudgetTest, GivesAnInnerLoopTheThreadThatIsDoneWithTheOuterOrWaitsForIt)
{
  const std::thread::id caller = std::this_thread::get_id();
  for (bool caller_goes_on : {false, true})
  {
    ThreadBudget budget(2);
    std::atomic<int> begun{0};
    ThreadCounter counter;
    budget.for_each(2, [&](std::size_t) {
      ++begun;
      while (begun < 2) std::this_thread::yield();
      // One of the two threads ends here. The other goes on until it has company in its inner loop.
      if ((std::this_thread::get_id() == caller) != caller_goes_on) return;
      while (counter.most() < 2) budget.for_each(2, [&](std::size_t) { counter.work(); });
    });
    EXPECT_EQ(counter.most(), 2);
  }
}

TEST(ThreadBudgetTest, WorksInTheCallingThreadAloneWhereThereIsNoOther)
{
  ThreadBudget budget(1);
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<std::size_t> order;
  budget.for_each(3, [&](std::size_t i) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    budget.for_each(2, [&](std::size_t j) { order.push_back(2 * i + j); });
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
}

/// What the loop throws when the given calls throw their index.
std::string thrown(ThreadBudget& budget, std::size_t count, const std::set<std::size_t>& bad, std::atomic<int>& calls)
{
  try
  {
    budget.for_each(count, [&](std::size_t i) {
      ++calls;
      if (bad.count(i)) throw std::runtime_error(std::to_string(i));
    });
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

TEST(ThreadBudgetTest, ThrowsWhatAPlainLoopWouldThrow)
{
  for (int threads : {1, 2, 8})
    for (int repetition = 0; repetition < 20; ++repetition)
    {
      ThreadBudget budget(threads);
      std::atomic<int> calls{0};
      EXPECT_EQ(thrown(budget, 100, {7, 8, 9, 50}, calls), "7");
      EXPECT_GE(calls, 8);
      EXPECT_TRUE(threads > 1 || calls == 8) << "no calls begin after one has failed";
      EXPECT_EQ(thrown(budget, 100, {99}, calls), "99");
      EXPECT_EQ(thrown(budget, 100, {}, calls), "") << "the budget is as good as new";
    }
}

TEST(ThreadBudgetTest, PassesExceptionsOnThroughNestedLoops)
{
  for (int threads : {1, 2, 8})
  {
    ThreadBudget budget(threads);
    const auto nested = [&](std::size_t i) {
      budget.for_each(4, [&](std::size_t j) {
        if (i == 1 && j == 2) throw std::runtime_error("inner");
      });
    };
    EXPECT_THROW(budget.for_each(3, nested), std::runtime_error);
    ThreadCounter counter;
    budget.for_each(20, [&](std::size_t) { counter.work(); });
    EXPECT_LE(counter.most(), threads);
  }
}

TEST(ThreadBudgetTest, RejectsLessThanOneThread)
{
  for (int none : {0, -1}) EXPECT_THROW(ThreadBudget{none}, std::invalid_argument);
  EXPECT_GE(hardware_threads(), 1);
}

}  // namespace
}  // namespace fourwis
