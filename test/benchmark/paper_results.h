#pragma once

#include <array>
#include <stdexcept>
#include <string>

namespace fourwis::benchmark
{

/// A line of the paper's comparison on its environments: the planner in Ackermann motion ("Single-SC") or in all modes
/// ("Multi-SC").
struct PaperResult
{
  const char* environment;
  bool all_modes;
  double length;                         ///< TL [m]
  double arrival_time;                   ///< AT [s]
  double mean_curvature, max_curvature;  ///< AC, MC [1/m]
  double standard_mode_rate;             ///< SMR
  double ms;                             ///< CT
};

inline constexpr std::array<PaperResult, 8> kPaperResults = {
    {{"env1", false, 48.396, 49.592, 0.186, 1.695, 1.000, 9074.1},
     {"env1", true, 45.790, 46.387, 0.193, 1.695, 1.000, 5526.0},
     {"env2", false, 17.697, 18.898, 0.471, 1.698, 1.000, 3154.9},
     {"env2", true, 16.762, 18.196, 0.176, 1.695, 1.000, 2628.0},
     {"env3", false, 8.0603, 8.8749, 0.426, 1.695, 1.000, 1542.6},
     {"env3", true, 7.8961, 8.7113, 0.102, 3.142, 1.000, 1025.7},
     {"env4", false, 14.980, 19.814, 0.816, 1.698, 1.000, 2927.9},
     {"env4", true, 14.243, 16.857, 0.815, 2.220, 1.000, 1961.8}}};

/// Throws std::runtime_error for an environment that is none of the paper's.
inline const PaperResult& paper_result(const std::string& environment, bool all_modes)
{
  for (const PaperResult& result : kPaperResults)
    if (result.environment == environment && result.all_modes == all_modes) return result;
  throw std::runtime_error("'" + environment + "': expected one of env1 to env4");
}

}  // namespace fourwis::benchmark
