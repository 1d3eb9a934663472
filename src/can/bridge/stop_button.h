#pragma once

#include <atomic>
#include <cstdint>

namespace fourwis::can
{

/// An emergency stop that is pressed in one thread and obeyed in another. Even a very short press is obeyed. Neither
/// thread waits.
class StopButton
{
public:
  /// To be called by one thread at a time.
  void set(bool pressed) { state_ = pressed ? (state_ + kPress) | kPressed : state_ & ~kPressed; }

  /// To be called by the thread that obeys. Calls `obey(pressed)` for what has happened since the last call, in order.
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

  std::atomic<std::uint32_t> state_{0};  ///< kPressed while it is pressed, plus kPress for each press
  std::uint32_t obeyed_ = 0;
};

}  // namespace fourwis::can
