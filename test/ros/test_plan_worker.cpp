#include <atomic>
#include <future>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "ros/plan_worker.h"

namespace fourwis
{
namespace
{

/// Runs until it is cancelled, which is all that ends it.
void run_until(const std::atomic<bool>& cancelled)
{
  while (!cancelled) std::this_thread::yield();
}

TEST(PlanWorker, runs_a_task_in_a_thread_of_its_own)
{
  PlanWorker worker;
  std::promise<std::thread::id> done;
  worker.submit([&done](const std::atomic<bool>&) { done.set_value(std::this_thread::get_id()); });
  EXPECT_NE(done.get_future().get(), std::this_thread::get_id());
}

TEST(PlanWorker, a_new_task_cancels_the_one_that_runs)
{
  PlanWorker worker;
  std::promise<void> started, first;
  std::promise<bool> second;
  worker.submit([&](const std::atomic<bool>& cancelled) {
    started.set_value();
    run_until(cancelled);
    first.set_value();
  });
  started.get_future().wait();
  worker.submit([&](const std::atomic<bool>& cancelled) { second.set_value(cancelled); });
  first.get_future().wait();
  EXPECT_FALSE(second.get_future().get());
}

TEST(PlanWorker, of_many_waiting_tasks_all_are_told_and_only_the_newest_runs_uncancelled)
{
  PlanWorker worker;
  std::promise<void> started, last;
  std::vector<int> order, uncancelled;
  worker.submit([&](const std::atomic<bool>& cancelled) { started.set_value(), run_until(cancelled); });
  started.get_future().wait();
  for (int i = 0; i < 5; ++i)
    worker.submit([&, i](const std::atomic<bool>& cancelled) {
      order.push_back(i);
      if (!cancelled) uncancelled.push_back(i);
      if (i == 4) last.set_value();
    });
  last.get_future().wait();
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4}));
  // A task before the newest may have begun before the next was submitted, but the newest always runs.
  ASSERT_FALSE(uncancelled.empty());
  EXPECT_EQ(uncancelled.back(), 4);
}

TEST(PlanWorker, cancel_ends_what_runs_and_says_whether_anything_did)
{
  PlanWorker worker;
  EXPECT_FALSE(worker.cancel());
  std::promise<void> started, ended;
  worker.submit([&](const std::atomic<bool>& cancelled) {
    started.set_value();
    run_until(cancelled);
    ended.set_value();
  });
  started.get_future().wait();
  EXPECT_TRUE(worker.cancel());
  ended.get_future().wait();
}

TEST(PlanWorker, a_ticket_cancels_its_own_task)
{
  PlanWorker worker;
  std::promise<void> ended;
  const PlanWorker::Ticket ticket =
      worker.submit([&](const std::atomic<bool>& cancelled) { run_until(cancelled), ended.set_value(); });
  *ticket = true;
  ended.get_future().wait();
}

TEST(PlanWorker, its_end_cancels_everything_and_waits_for_it)
{
  int told = 0;
  {
    PlanWorker worker;
    for (int i = 0; i < 3; ++i)
      worker.submit([&](const std::atomic<bool>& cancelled) { run_until(cancelled), ++told; });
  }
  EXPECT_EQ(told, 3);
}

}  // namespace
}  // namespace fourwis
