#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace fourwis::can
{

/// Hands the newest value from one thread to another one. A value that was not taken is replaced. Neither thread waits
/// or allocates: of three slots one is written, one waits, one is read.
template <class T>
class Mailbox
{
public:
  /// To be called by one thread only.
  void put(const T& value)
  {
    slots_[writing_] = value;
    writing_ = waiting_.exchange(writing_ | kNew, std::memory_order_acq_rel) & kSlot;
  }

  /// To be called by the other thread only. Returns whether there is a new value since the last call, and sets `value`
  /// to it.
  bool take(T& value)
  {
    if ((waiting_.load(std::memory_order_relaxed) & kNew) == 0) return false;
    reading_ = waiting_.exchange(reading_, std::memory_order_acq_rel) & kSlot;
    value = slots_[reading_];
    return true;
  }

private:
  static constexpr std::uint8_t kSlot = 3, kNew = 4;

  std::array<T, 3> slots_{};
  std::atomic<std::uint8_t> waiting_{1};
  std::uint8_t writing_ = 0, reading_ = 2;
};

}  // namespace fourwis::can
