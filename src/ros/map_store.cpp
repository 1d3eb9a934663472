#include "map_store.h"

#include <chrono>
#include <utility>

#include "conversions.h"
#include "frame_name.h"

namespace fourwis
{

MapStore::MapStore(std::string global_frame, const Robot& robot, const PlannerOptions& options, Refused refused)
  : global_frame_(std::move(global_frame)),
    robot_(robot),
    options_(options),
    refused_(std::move(refused)),
    thread_([this] { run(); })
{}

MapStore::~MapStore()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void MapStore::add(const nav_msgs::OccupancyGridConstPtr& map)
{
  try
  {
    check_frame("map", map->header.frame_id);
    check_map(*map);
    enqueue([&map](Arrivals& arrivals) { arrivals = {map, {}}; });
    map_refused_ = false;
  }
  catch (const ConversionError& error)
  {
    map_refused_ = true;
    refused_(error.what());
  }
}

void MapStore::add(const map_msgs::OccupancyGridUpdateConstPtr& update)
{
  try
  {
    check_frame("map update", update->header.frame_id);
    if (map_refused_) throw ConversionError("map update: there is no usable map that it could change");
    enqueue([&update](Arrivals& arrivals) { arrivals.updates.push_back(update); });
  }
  catch (const ConversionError& error)
  {
    refused_(error.what());
  }
}

void MapStore::enqueue(const std::function<void(Arrivals&)>& insert)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    insert(arrivals_);
    const Clock::time_point now = Clock::now();
    if (handled_ == arrived_) oldest_ = now;
    if (taken_ == arrived_) next_ = now;
    ++arrived_;
  }
  changed_.notify_all();
}

MapStore::Snapshot MapStore::newest() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return newest_;
}

double MapStore::waiting() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return handled_ == arrived_ ? 0.0 : std::chrono::duration<double>(Clock::now() - oldest_).count();
}

MapStore::Snapshot MapStore::wait_for_newest(const std::atomic<bool>& cancelled) const
{
  std::unique_lock<std::mutex> lock(mutex_);
  const std::uint64_t wanted = arrived_;
  // A cancel does not notify, so the wait is cut into short ones.
  while (handled_ < wanted && !stopping_ && !cancelled) changed_.wait_for(lock, std::chrono::milliseconds(5));
  return newest_;
}

void MapStore::run()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (true)
  {
    changed_.wait(lock, [this] { return stopping_ || handled_ < arrived_; });
    if (stopping_) return;
    const Arrivals arrivals = std::exchange(arrivals_, {});
    taken_ = arrived_;
    lock.unlock();
    build(arrivals);
    lock.lock();
    handled_ = taken_;
    oldest_ = next_;
    changed_.notify_all();
  }
}

void MapStore::build(const Arrivals& arrivals)
{
  try
  {
    const Snapshot base = newest();
    if (!arrivals.map && !base) throw ConversionError("map update: there is no usable map that it could change");
    OccupancyGrid grid = arrivals.map ? to_grid(*arrivals.map) : base->world.grid;
    ros::Time stamp = arrivals.map ? arrivals.map->header.stamp : base->stamp;
    bool changed = arrivals.map != nullptr;
    for (const auto& update : arrivals.updates)
    {
      if (!apply(*update, grid)) continue;
      stamp = update->header.stamp;
      changed = true;
    }
    if (!changed) return;

    auto snapshot = std::make_shared<const MapSnapshot>(MapSnapshot{World(grid, robot_, options_), stamp});
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_ = std::move(snapshot);
  }
  catch (const std::exception& error)
  {
    // Anything: a map that does not fit into memory must not end the node.
    refused_(error.what());
  }
}

bool MapStore::apply(const map_msgs::OccupancyGridUpdate& update, OccupancyGrid& grid) const
{
  try
  {
    apply_update(update, grid);
    return true;
  }
  catch (const ConversionError& error)
  {
    refused_(error.what());
    return false;
  }
}

void MapStore::check_frame(const std::string& name, const std::string& frame) const
{
  if (without_slash(frame) != global_frame_)
    throw ConversionError(name + ": header.frame_id is '" + frame + "', expected the global_frame '" + global_frame_ +
                          "'");
}

}  // namespace fourwis
