#include "fourwis_navigation/referee/referee.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fourwis_navigation/model/option_check.h"
#include "motion.h"
#include "obstacle_cells.h"
#include "rollout.h"
#include "rules.h"

namespace fourwis
{
namespace
{

/// The place at time t on the way from one point towards the next.
TrajectoryPoint place_between(const Robot& robot, const TrajectoryPoint& from, const TrajectoryPoint& to, double t)
{
  TrajectoryPoint place = from;
  place.t = t;
  if (from.mode != to.mode) return place;
  referee::Rollout rollout(robot, from, to);
  const double share = (t - from.t) / (to.t - from.t);
  rollout.advance(share);
  place.x = rollout.x();
  place.y = rollout.y();
  place.theta = rollout.theta();
  place.v += share * (to.v - from.v);
  place.phi += share * (to.phi - from.phi);
  return place;
}

/// What is left of a trajectory at time t.
Trajectory rest_of(const Robot& robot, const Trajectory& trajectory, double t)
{
  const auto next = std::find_if(trajectory.begin(), trajectory.end(), [t](const auto& point) { return point.t > t; });
  if (next == trajectory.begin()) return trajectory;
  if (next == trajectory.end()) return {trajectory.back()};
  Trajectory rest{place_between(robot, *std::prev(next), *next, t)};
  rest.insert(rest.end(), next, trajectory.end());
  return rest;
}

}  // namespace

void check(const RefereeOptions& options)
{
  check_ranges(options);
}

Referee::Referee(const OccupancyGrid& grid, const ObstacleRule& rule, const Robot& robot, const RefereeOptions& options,
                 const Pose& frame)
  : cells_(std::make_shared<referee::ObstacleCells>(grid, checked(rule))),
    robot_(checked(robot)),
    options_(checked(options)),
    frame_(frame)
{}

Verdict Referee::judge(const Pose& start, const Pose& goal, const Trajectory& trajectory) const
{
  Verdict verdict;
  referee::Report report;
  const referee::Judgement judgement{robot_, options_, trajectory, report, frame_};
  if (referee::check_form(judgement))
  {
    verdict.terminal_position_error = distance(trajectory.back().pose(), goal);
    verdict.terminal_yaw_error = std::abs(wrap_angle(trajectory.back().theta - goal.theta));
    referee::check_ends(judgement, start, goal);
    referee::check_limits(judgement);
    referee::check_wheels(judgement);
    referee::check_motion(judgement, *cells_, verdict);
  }
  verdict.violations = report.sorted();
  return verdict;
}

std::optional<Violation> Referee::first_violation_from(double t, const Trajectory& accepted) const
{
  if (accepted.empty()) return std::nullopt;
  const Trajectory rest = rest_of(robot_, accepted, t);
  Verdict verdict;
  referee::Report report;
  RefereeOptions strict = options_;
  strict.start_tolerance = 0.0;
  referee::check_motion({robot_, strict, rest, report, frame_}, *cells_, verdict);
  const std::vector<Violation> violations = report.sorted();
  if (violations.empty()) return std::nullopt;
  Violation first = violations.front();
  first.point += static_cast<int>(accepted.size() - rest.size());
  return first;
}

}  // namespace fourwis
