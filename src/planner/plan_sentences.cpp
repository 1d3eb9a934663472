#include "plan_sentences.h"

#include <algorithm>
#include <utility>

#include "fourwis_navigation/search/search.h"

namespace fourwis
{
namespace
{

std::string collision_sentence(const char* what, const Pose& pose, double clearance)
{
  return sentence("%s (%.3f, %.3f, %.3f) is in collision: the covering discs are %.3f m too close to an obstacle", what,
                  pose.x, pose.y, pose.theta, -clearance);
}

}  // namespace

PlanResult refusal(PlanStatus status, std::string message)
{
  PlanResult result;
  result.status = status;
  result.message = std::move(message);
  return result;
}

PlanResult check_request(const CollisionChecker& checker, const PlanRequest& request)
{
  if (!is_finite(request.start)) return refusal(PlanStatus::invalid_input, "the start pose is not finite");
  if (!is_finite(request.goal)) return refusal(PlanStatus::invalid_input, "the goal pose is not finite");
  if (request.modes.empty()) return refusal(PlanStatus::invalid_input, "no motion mode is allowed");
  if (!checker.is_free(request.start))
    return refusal(PlanStatus::start_in_collision,
                   collision_sentence("the start", request.start, checker.clearance(request.start)));
  if (!checker.is_free(request.goal))
    return refusal(PlanStatus::goal_in_collision,
                   collision_sentence("the goal", request.goal, checker.clearance(request.goal)));
  return refusal(PlanStatus::succeeded, "");
}

std::string search_sentence(PlanStatus status, int expansions, const PlanRequest& request)
{
  switch (status)
  {
    case PlanStatus::goal_unreachable:
      return sentence("the robot cannot get from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f): %s", request.start.x,
                      request.start.y, request.start.theta, request.goal.x, request.goal.y, request.goal.theta,
                      may_turn(request.start, request.goal, request.modes) ? "no way is wide enough"
                                                                           : "parallel motion alone does not turn");
    case PlanStatus::timeout: return sentence("planner_patience was over after %d expansions", expansions);
    case PlanStatus::cancelled: return sentence("cancelled after %d expansions", expansions);
    default:
      return sentence(
          "no path found in %d expansions, and no proof that there is none: %s", expansions,
          request.modes == ModeSet() ? "the way may be too narrow to turn in" : "more modes may get through");
  }
}

}  // namespace fourwis
