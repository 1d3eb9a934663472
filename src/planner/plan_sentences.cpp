#include "plan_sentences.h"

#include <algorithm>

#include "fourwis_navigation/search/search.h"

namespace fourwis
{

std::string remarks(const PlanResult& result, const std::string& why)
{
  std::string text;
  if (result.fallback_parts > 0 && !why.empty())
    text += sentence("; %d of its parts stop%s wherever the steering changes (%s)", result.fallback_parts,
                     result.fallback_parts == 1 ? "s" : "", why.c_str());
  if (result.degraded) text += "; planner_patience was over before it was optimised";
  return text;
}

std::string search_sentence(const World& world, const PlanResult& result, const PlanRequest& asked)
{
  const int expansions = result.metrics.expansions;
  switch (result.status)
  {
    case PlanStatus::goal_unreachable:
      return sentence("the robot cannot get from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f): ", asked.start.x,
                      asked.start.y, asked.start.theta, asked.goal.x, asked.goal.y, asked.goal.theta) +
             (may_turn(asked.start, asked.goal, asked.modes)
                  ? sentence("no way is wide enough for a body of %.2f x %.2f m with a margin of %.3f m on each side",
                             world.robot.body_length(), world.robot.body_width(), world.robot.safety_margin)
                  : "parallel motion alone does not turn");
    case PlanStatus::timeout: return sentence("planner_patience was over after %d expansions", expansions);
    case PlanStatus::cancelled: return sentence("cancelled after %d expansions", expansions);
    default:
      return sentence("no path found in %d expansions, and no proof that there is none: %s", expansions,
                      asked.modes == ModeSet() ? "the way may be too narrow to turn in" : "more modes may get through");
  }
}

}  // namespace fourwis
