// Robots that are pushed off their trajectory return to it, or stop with a message, and stay within the bound of
// doc/design.md.

#include <gtest/gtest.h>

#include "../support/random.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "track/reference.h"
#include "track_fixture.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 48;

/// Poses along the trajectory, about one per centimetre.
std::vector<Pose> places(const Robot& robot, const Trajectory& trajectory)
{
  std::vector<Pose> all;
  for (std::size_t k = 0; k + 1 < trajectory.size(); ++k)
  {
    if (trajectory[k].mode != trajectory[k + 1].mode) continue;
    const Reference interval(robot, &trajectory[k], &trajectory[k] + 2);
    for (double t = trajectory[k].t; t < trajectory[k + 1].t; t += 0.01) all.push_back(interval.at(t).state.pose);
  }
  return all;
}

double distance_to(const std::vector<Pose>& places, const Pose& pose)
{
  double least = 1e9;
  for (const Pose& place : places) least = std::min(least, distance(place, pose));
  return least;
}

/// The bound of doc/design.md for the distance from the trajectory of a robot that is pushed aside by `push`.
double bound(const Robot& robot, const TrackOptions& options, const Pose& push)
{
  const double v = robot.max_speed, late = options.command_latency + 1.0 / options.controller_frequency;
  const double way = v * (late + v / (2.0 * robot.max_acceleration));  // to a stop
  const double aside = std::max(options.max_lateral_error, std::hypot(push.x, push.y));
  const double heading = std::max(options.max_heading_error, std::abs(push.theta));
  return aside + way * std::sin(heading) + max_curvature(robot, Mode::lateral) * way * way;
}

TEST(Pushes, EndAtTheGoalOrInAStopWithinTheBound)
{
  Random random(kSeed);
  int arrived = 0, stopped = 0;
  for (int trial = 0; trial < 150; ++trial)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    Rig rig;
    std::vector<Piece> pieces;
    for (int k = 0; k < 3; ++k)
    {
      const Mode mode = random.mode();
      pieces.push_back({mode, 0.7 * random.steering(rig.robot, mode), random.between(0.5, 2.0)});
    }
    const Trajectory trajectory = trajectory_of(rig.robot, {}, pieces);
    const std::vector<Pose> all = places(rig.robot, trajectory);
    ASSERT_EQ(rig.tracker.accept(trajectory), "");
    const double moment = random.between(0.0, trajectory.back().t);
    rig.step_until([&] { return rig.output.t >= moment || is_resting(rig.output.state); });

    const double size = random.between(0.0, 0.25), direction = random.angle();
    const Pose push = {size * std::cos(direction), size * std::sin(direction), random.between(-0.4, 0.4)};
    rig.base.push(compose(rig.base.pose(), push));
    double farthest = 0.0;
    rig.step_until([&] {
      farthest = std::max(farthest, distance_to(all, rig.base.pose()));
      return is_resting(rig.output.state);
    });
    EXPECT_LT(farthest, bound(rig.robot, ideal_options(), push));
    if (rig.output.state == TrackState::arrived)
      EXPECT_LE(distance(rig.base.pose(), trajectory.back().pose()), 0.01);
    else
      EXPECT_NE(rig.message, "");
    arrived += rig.output.state == TrackState::arrived;
    stopped += rig.output.state == TrackState::failed;
  }
  EXPECT_EQ(arrived + stopped, 150);
  EXPECT_GT(arrived, 30);
  EXPECT_GT(stopped, 30);
}

}  // namespace
}  // namespace fourwis
