#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/subscriber.h>

namespace fourwis
{

/// How long a test waits for what must happen before it fails [s]; nothing is ever waited for just because time passes.
inline constexpr double kPatience = 30.0;

/// Polls a condition that has no notification. Whether it came true.
inline bool wait_until(const std::function<bool()>& condition)
{
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (!condition())
  {
    if (ros::WallTime::now() > end) return false;
    ros::WallDuration(0.005).sleep();
  }
  return true;
}

/// Keeps what arrives on a topic, for tests that spin elsewhere.
template <class Message>
class Inbox
{
public:
  using Pointer = boost::shared_ptr<const Message>;

  explicit Inbox(const std::string& topic)
    : subscriber_(ros::NodeHandle().subscribe<Message>(topic, 1000, [this](const Pointer& m) { receive(m); }))
  {}

  /// The first message since the last clear() that satisfies the condition; null when none comes.
  Pointer wait_for(const std::function<bool(const Message&)>& condition)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    Pointer found;
    const auto arrived = [&] {
      for (const Pointer& message : messages_)
        if (condition(*message)) return found = message, true;
      return false;
    };
    changed_.wait_for(lock, std::chrono::duration<double>(kPatience), arrived);
    return found;
  }

  Pointer wait_for_any()
  {
    return wait_for([](const Message&) { return true; });
  }

  std::vector<Pointer> messages() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }

  void clear()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.clear();
  }

  bool connected() const { return subscriber_.getNumPublishers() > 0; }

private:
  void receive(const Pointer& message)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    messages_.push_back(message);
    changed_.notify_all();
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Pointer> messages_;
  ros::Subscriber subscriber_;  ///< last: its callback uses all of the above
};

}  // namespace fourwis
