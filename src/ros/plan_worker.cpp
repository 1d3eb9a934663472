#include "plan_worker.h"

#include <utility>

namespace fourwis
{

PlanWorker::PlanWorker() : thread_([this] { run(); }) {}

PlanWorker::~PlanWorker()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    cancel_locked();
  }
  changed_.notify_all();
  thread_.join();
}

PlanWorker::Ticket PlanWorker::submit(Task task)
{
  auto ticket = std::make_shared<std::atomic<bool>>(false);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    cancel_locked();
    waiting_.push_back({std::move(task), ticket});
  }
  changed_.notify_all();
  return ticket;
}

bool PlanWorker::cancel()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return cancel_locked();
}

bool PlanWorker::is_busy() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return running_ || !waiting_.empty();
}

bool PlanWorker::cancel_locked()
{
  for (const Job& job : waiting_) *job.cancelled = true;
  if (running_) *running_ = true;
  return running_ || !waiting_.empty();
}

void PlanWorker::run()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (true)
  {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    Job job = std::move(waiting_.front());
    waiting_.pop_front();
    running_ = job.cancelled;
    lock.unlock();
    job.task(*job.cancelled);
    job = {};  // what it holds may lock, too
    lock.lock();
    running_.reset();
  }
}

}  // namespace fourwis
