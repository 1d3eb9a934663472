#pragma once

#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Random numbers that are the same in every run.
class Random
{
public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  double unit() { return between(-1.0, 1.0); }
  /// Normally distributed about 0.
  double normal(double deviation) { return std::normal_distribution<double>(0.0, deviation)(engine_); }
  /// A whole number in low..high.
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  bool chance(double probability) { return between(0.0, 1.0) < probability; }
  double angle() { return between(-M_PI, M_PI); }
  Mode mode() { return kPlannedModes[static_cast<std::size_t>(whole(0, 2))]; }
  /// An equivalent steering angle the mode allows.
  double steering(const Robot& robot, Mode mode)
  {
    const double limit = mode == Mode::parallel ? M_PI_2 : robot.max_steering_angle;
    return between(-limit, limit);
  }
  Pose pose(double size) { return {between(-size, size), between(-size, size), angle()}; }

private:
  std::mt19937_64 engine_;
};

/// A pose for messages, with all its digits.
inline std::string text(const Pose& pose)
{
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "(%.17g, %.17g, %.17g)", pose.x, pose.y, pose.theta);
  return buffer;
}

/// The difference of two headings up to full turns [rad].
inline double heading_gap(double a, double b)
{
  return std::abs(wrap_angle(a - b));
}

/// The sets of modes that are not empty.
inline std::vector<ModeSet> all_mode_sets()
{
  std::vector<ModeSet> sets;
  for (unsigned bits = 1; bits < 1u << kPlannedModes.size(); ++bits)
  {
    ModeSet modes = ModeSet::none();
    for (std::size_t k = 0; k < kPlannedModes.size(); ++k)
      if (bits >> k & 1) modes.insert(kPlannedModes[k]);
    sets.push_back(modes);
  }
  return sets;
}

inline std::string text(const ModeSet& modes)
{
  std::string names;
  for (Mode mode : kPlannedModes)
    if (modes.contains(mode)) names += std::string(names.empty() ? "" : "+") + to_string(mode);
  return names.empty() ? "no mode" : names;
}

}  // namespace fourwis
