#pragma once

namespace fourwis
{

/// How trajectories are tracked; the keys of config/mpc.yaml.
struct TrackOptions
{
  double controller_frequency = 50.0;  ///< control steps each second [Hz]
};

}  // namespace fourwis
