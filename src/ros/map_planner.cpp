#include "map_planner.h"

namespace fourwis
{

MapPlanner::MapPlanner(const Planner& planner, const MapStore& maps, bool traced)
  : planner_(planner),
    maps_(maps),
    traced_(traced)
{}

PlanAnswer MapPlanner::judge_goal(const Pose& goal) const
{
  PlanAnswer answer;
  answer.result.status = PlanStatus::succeeded;
  const MapStore::Snapshot map = maps_.newest();
  if (!map) return answer;
  answer.map_stamp = map->stamp;
  answer.result = planner_.judge_goal(map->world, goal);
  return answer;
}

PlanAnswer MapPlanner::plan(const PlanRequest& request, const std::atomic<bool>& cancelled) const
{
  PlanAnswer answer;
  answer.request = request;
  const MapStore::Snapshot map = maps_.wait_for_newest(cancelled);
  if (cancelled)
  {
    answer.result = no_plan(PlanStatus::cancelled, "cancelled before planning began");
    return answer;
  }
  if (!map)
  {
    answer.result = no_plan(PlanStatus::invalid_input, "no usable map received yet on topic 'map'");
    return answer;
  }
  answer.map_stamp = map->stamp;
  answer.result = planner_.plan(map->world, request, Interrupt(&cancelled), traced_ ? &answer.trace : nullptr);
  return answer;
}

}  // namespace fourwis
