#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "../support/grids.h"
#include "referee_script.h"

namespace fourwis
{

inline constexpr double kDegree = M_PI / 180.0;

inline const OccupancyGrid& hall()
{
  static const OccupancyGrid grid = free_grid(400, 400, 0.05, {-10.0, -10.0, 0.0});
  return grid;
}

inline Verdict judge(const Trajectory& points, const Pose& start, const Pose& goal, const Robot& robot = {})
{
  return Referee(hall(), ObstacleRule(), robot).judge(start, goal, points);
}

inline Verdict judge(const Script& script, const Robot& robot = {})
{
  return judge(script.points(), script.start(), script.end(), robot);
}

/// All modes, steering in motion and at rest, both directions, two switches.
inline Script grand_tour()
{
  Script script({-1.0, 0.5, 0.3}, Mode::ackermann);
  script.go(0.25, 1.0, 0.0).go(0.5, 1.0, 0.4).go(0.5, 0.5, -0.1).go(0.25, 0.0, -0.1);
  script.switch_to(Mode::lateral, 0.2, 0.6);
  script.go(0.25, -0.8, 0.2).go(0.5, -0.8, -0.2).go(0.25, 0.0, -0.2);
  script.switch_to(Mode::parallel, 1.0, 0.6);
  script.go(0.25, 1.0, 1.0).go(0.5, 1.0, 1.8).go(0.25, 0.0, 1.8).go(1.0, 0.0, 0.3).drive(-0.5, 1.0);
  return script;
}

inline void expect_accepted(const Verdict& verdict)
{
  EXPECT_TRUE(verdict.accepted()) << sentences(verdict);
}

inline void expect_refused(const Verdict& verdict, const std::string& what)
{
  EXPECT_FALSE(verdict.accepted()) << "expected: " << what;
  EXPECT_TRUE(complains_of(verdict, what)) << "expected: " << what << "\nfound:\n" << sentences(verdict);
}

/// The tour with changed points, but the same start and goal.
inline Verdict judge_changed(const std::function<void(Trajectory&)>& change)
{
  const Script tour = grand_tour();
  Trajectory points = tour.points();
  change(points);
  return judge(points, tour.start(), tour.end());
}

}  // namespace fourwis
