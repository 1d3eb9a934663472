#pragma once

#include <cstdint>

namespace fourwis::drives
{

/// Rounding error of times that are sums of many steps [s].
inline constexpr double kTimeRounding = 1e-9;

/// Decides when a heartbeat is due.
class HeartbeatProducer
{
public:
  /// `period` [ms]; 0: never. A new period begins now.
  bool is_due(double now, std::int64_t period)
  {
    if (period != period_) last_ = now;
    period_ = period;
    if (period == 0 || now - last_ < static_cast<double>(period) * 1e-3 - kTimeRounding) return false;
    last_ = now;
    return true;
  }

private:
  std::int64_t period_ = 0;
  double last_ = 0.0;
};

/// Watches the heartbeat of another node, after it has received the first one.
class HeartbeatConsumer
{
public:
  /// 1016:1 = node << 16 | ms. 0 for one of them: no node is watched. Another value starts anew.
  void configure(std::int64_t setting)
  {
    if (setting == setting_) return;
    setting_ = setting;
    watching_ = false;
  }
  std::uint32_t node() const { return static_cast<std::uint32_t>(setting_ >> 16) & 0x7F; }

  void heard(double now)
  {
    if (node() == 0 || (setting_ & 0xFFFF) == 0) return;
    watching_ = true;
    last_ = now;
  }

  double silence(double now) const { return now - last_; }  ///< time since the last heartbeat [s]

  /// True once each time that the heartbeat is lost.
  bool has_lost(double now)
  {
    if (!watching_ || now - last_ < static_cast<double>(setting_ & 0xFFFF) * 1e-3 - kTimeRounding) return false;
    watching_ = false;
    return true;
  }

private:
  std::int64_t setting_ = 0;
  bool watching_ = false;
  double last_ = 0.0;
};

}  // namespace fourwis::drives
