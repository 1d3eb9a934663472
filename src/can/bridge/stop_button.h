#pragma once

#include <atomic>
#include <cstdint>

namespace fourwis::can
{

/// An emergency stop, pressed in one thread and obeyed in another. However short a press is, it is obeyed. Neither side
/// waits.
class StopButton
{
public:
  /// One thread at a time.
  void set(bool pressed) { state_ = pressed ? (state_ + kPress) | kPressed : state_ & ~kPressed; }

  /// The thread that obeys: what has happened since the last time, by calls of `obey(pressed)`, in order.
  template <class Obey>
  void pass_on(Obey obey)
  {
    const std::uint32_t state = state_;
    const std::uint32_t before = obeyed_;
    if (state == before) return;
    obeyed_ = state;
    if (state / kPress != before / kPress) obey(true);
    if ((state & kPressed) == 0) obey(false);
  }

private:
  static constexpr std::uint32_t kPressed = 1, kPress = 2;

  std::atomic<std::uint32_t> state_{0};  ///< kPressed while it is, and kPress for each time it was
  std::uint32_t obeyed_ = 0;
};

}  // namespace fourwis::can
