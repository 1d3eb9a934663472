#include "fourwis_navigation/ros/map_planner.h"

#include <chrono>

namespace fourwis
{
namespace
{

PlanResult failure(PlanStatus status, const std::string& message)
{
  PlanResult result;
  result.status = status;
  result.message = message;
  return result;
}

Interrupt::Clock::time_point after(double seconds)
{
  return Interrupt::Clock::now() +
         std::chrono::duration_cast<Interrupt::Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

MapPlanner::MapPlanner(const Planner& planner, const MapStore& maps, bool traced)
  : planner_(planner), maps_(maps), traced_(traced)
{
}

PlanAnswer MapPlanner::plan(const PlanRequest& request, const std::atomic<bool>& cancelled) const
{
  PlanAnswer answer;
  answer.request = request;
  const MapStore::Snapshot map = maps_.wait_for_newest(cancelled);
  if (cancelled)
  {
    answer.result = failure(PlanStatus::cancelled, "cancelled before planning began");
    return answer;
  }
  if (!map)
  {
    answer.result = failure(PlanStatus::invalid_input, "no usable map received yet on topic 'map'");
    return answer;
  }
  answer.map_stamp = map->stamp;
  const Interrupt interrupt(&cancelled, after(planner_.options().planner_patience));
  answer.result = planner_.plan(map->world, request, interrupt, traced_ ? &answer.trace : nullptr);
  return answer;
}

}  // namespace fourwis
