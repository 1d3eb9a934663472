#include "map_planner.h"

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

}  // namespace

MapPlanner::MapPlanner(const Planner& planner, const MapStore& maps, bool traced)
  : planner_(planner),
    maps_(maps),
    traced_(traced)
{}

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
  answer.result = planner_.plan(map->world, request, Interrupt(&cancelled), traced_ ? &answer.trace : nullptr);
  return answer;
}

}  // namespace fourwis
