#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fourwis::benchmark
{

/// The value below which the share q (0..1) of the sample lies, linear between its members. NaN for an empty sample.
inline double quantile(std::vector<double> sample, double q)
{
  if (sample.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(sample.begin(), sample.end());
  const double rank = q * static_cast<double>(sample.size() - 1);
  const std::size_t below = static_cast<std::size_t>(rank), above = std::min(below + 1, sample.size() - 1);
  return sample[below] + (rank - std::floor(rank)) * (sample[above] - sample[below]);
}

inline double median(std::vector<double> sample)
{
  return quantile(std::move(sample), 0.5);
}
inline double worst(std::vector<double> sample)
{
  return quantile(std::move(sample), 1.0);
}

}  // namespace fourwis::benchmark
