#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{

std::vector<Corridor> PlanTrace::corridors() const
{
  std::vector<Corridor> last;
  for (const std::vector<RefinementRound>& segment : rounds)
    if (!segment.empty()) last.push_back(segment.back().corridor);
  return last;
}

std::vector<Corridor> PlanTrace::all_corridors() const
{
  std::vector<Corridor> all;
  for (const std::vector<RefinementRound>& segment : rounds)
    for (const RefinementRound& round : segment) all.push_back(round.corridor);
  return all;
}

std::vector<Trajectory> PlanTrace::iterations() const
{
  std::vector<Trajectory> all;
  for (const std::vector<RefinementRound>& segment : rounds)
    for (std::size_t i = 0; i + 1 < segment.size(); ++i) all.push_back(segment[i].points);
  return all;
}

}  // namespace fourwis
