#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace fourwis::can
{

/// A histogram of delays: bins of 20 us up to 10 ms. No allocation.
class DelayStatistics
{
public:
  void add(double seconds)
  {
    const double bin = std::clamp(seconds / kBin, 0.0, kBins - 1.0);
    ++counts_[static_cast<std::size_t>(bin)];
    ++count_;
    longest_ = std::max(longest_, seconds);
  }

  std::uint64_t count() const { return count_; }
  double longest() const { return longest_; }  ///< [s]

  /// The delay that this share of all delays (0 to 1) did not exceed, rounded up to a bin [s]; 0 where there is none.
  double percentile(double share) const
  {
    const double wanted = share * static_cast<double>(count_);
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i)
      if (static_cast<double>(below += counts_[i]) >= wanted && below > 0)
        return std::min(longest_, kBin * static_cast<double>(i + 1));
    return longest_;
  }

private:
  static constexpr double kBin = 20e-6;
  static constexpr int kBins = 500;

  std::array<std::uint32_t, kBins> counts_{};
  std::uint64_t count_ = 0;
  double longest_ = 0.0;
};

}  // namespace fourwis::can
