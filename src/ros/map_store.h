#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/time.h>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{

/// A map and everything computed from it. Never changes: a plan that holds one is not touched by newer maps.
struct MapSnapshot
{
  World world;
  ros::Time stamp;  ///< header.stamp of the newest message in it
};

/// Turns maps and updates into snapshots on a thread of its own; what arrives during a build is taken together in the
/// next. Unusable messages are refused and change nothing, except that the updates that follow a refused map are
/// refused, too: they are meant for a map that is not here.
class MapStore
{
public:
  using Snapshot = std::shared_ptr<const MapSnapshot>;
  /// Called with a sentence for each refused message, from add() or from the thread.
  using Refused = std::function<void(const std::string&)>;

  MapStore(std::string global_frame, const Robot& robot, const PlannerOptions& options, Refused refused);
  ~MapStore();
  MapStore(const MapStore&) = delete;
  MapStore& operator=(const MapStore&) = delete;

  // Both return at once; call them from one thread.
  void add(const nav_msgs::OccupancyGridConstPtr& map);
  void add(const map_msgs::OccupancyGridUpdateConstPtr& update);

  /// The last one built; null when there is none.
  Snapshot newest() const;

  /// How long what arrived has been waiting to be built or refused [s], on a steady clock; 0 when nothing is.
  double waiting() const;

  /// Waits until all that was added before this call is built or refused, then newest(). Stops waiting when cancelled.
  Snapshot wait_for_newest(const std::atomic<bool>& cancelled) const;

private:
  using Clock = std::chrono::steady_clock;

  /// What arrived since the last build: at most one map, and the updates that came after it.
  struct Arrivals
  {
    nav_msgs::OccupancyGridConstPtr map;
    std::vector<map_msgs::OccupancyGridUpdateConstPtr> updates;
  };

  void enqueue(const std::function<void(Arrivals&)>& insert);
  void run();
  void build(const Arrivals& arrivals);
  bool apply(const map_msgs::OccupancyGridUpdate& update, OccupancyGrid& grid) const;
  void check_frame(const std::string& name, const std::string& frame) const;

  const std::string global_frame_;
  const Robot robot_;
  const PlannerOptions options_;
  const Refused refused_;

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  bool stopping_ = false;
  Arrivals arrivals_;
  std::uint64_t arrived_ = 0;  ///< messages ever added
  Clock::time_point oldest_;   ///< when the oldest that waits arrived: in a build, or for the next one
  Clock::time_point next_;     ///< when the oldest for the next build arrived
  std::uint64_t taken_ = 0;    ///< of these, into the build that goes on, or went last
  std::uint64_t handled_ = 0;  ///< of these, built or refused
  Snapshot newest_;

  bool map_refused_ = true;  ///< there was no map yet, or the last one was refused; used by add() only
  std::thread thread_;       ///< last: starts when all else is there
};

}  // namespace fourwis
