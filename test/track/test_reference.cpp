#include "track/reference.h"

#include <gtest/gtest.h>

#include "../support/drive.h"
#include "random_stretch.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 41;

Reference reference_of(const Robot& robot, const Trajectory& points)
{
  return Reference(robot, points.data(), points.data() + points.size());
}

/// The motion from a point on, by the midpoint rule in very small steps.
MotionState integrate(const Robot& robot, const TrajectoryPoint& from, const TrajectoryPoint& to, double time)
{
  constexpr int steps = 2000;
  const double h = time / steps, a = (to.v - from.v) / (to.t - from.t), omega = (to.phi - from.phi) / (to.t - from.t);
  MotionState state = {from.pose(), from.v, from.phi};
  for (int i = 0; i < steps; ++i)
  {
    const double v = from.v + (i + 0.5) * h * a, phi = from.phi + (i + 0.5) * h * omega;
    state.pose = advance(robot, state.pose, from.mode, phi, v * h);
  }
  return {state.pose, from.v + time * a, from.phi + time * omega};
}

TEST(Reference, FollowsTheKinematicsBetweenThePoints)
{
  const Robot robot;
  Random random(kSeed);
  for (int trial = 0; trial < 60; ++trial)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const Trajectory points = random_stretch(random, robot, random.mode());
    const Reference reference = reference_of(robot, points);
    const std::size_t k = static_cast<std::size_t>(random.whole(0, static_cast<int>(points.size()) - 2));
    const double time = random.between(0.0, points[k + 1].t - points[k].t);
    const MotionState expected = integrate(robot, points[k], points[k + 1], time);
    const ReferencePoint found = reference.at(points[k].t + time);
    EXPECT_NEAR(found.state.pose.x, expected.pose.x, 1e-6);
    EXPECT_NEAR(found.state.pose.y, expected.pose.y, 1e-6);
    EXPECT_NEAR(found.state.pose.theta, expected.pose.theta, 1e-6);
    EXPECT_NEAR(found.state.v, expected.v, 1e-9);
    EXPECT_NEAR(found.state.phi, expected.phi, 1e-9);
    EXPECT_NEAR(found.input.a, (points[k + 1].v - points[k].v) / 0.2, 1e-9);
  }
}

TEST(Reference, SpreadsWhatAPointIsMissedBy)
{
  const Robot robot;
  Random random(kSeed);
  Trajectory points = random_stretch(random, robot, Mode::ackermann);
  const Reference exact = reference_of(robot, points);
  points[5].x += 0.004;
  const Reference missed = reference_of(robot, points);
  const double begin = points[4].t, end = points[5].t, after = points[6].t;
  EXPECT_NEAR(missed.at(end - 1e-9).state.pose.x - exact.at(end - 1e-9).state.pose.x, 0.004, 1e-6);
  EXPECT_NEAR(missed.at(0.5 * (begin + end)).state.pose.x - exact.at(0.5 * (begin + end)).state.pose.x, 0.002, 1e-6);
  EXPECT_NEAR(missed.at(after).state.pose.x, exact.at(after).state.pose.x, 1e-9);
  for (double t = 0.0; t < points.back().t; t += 0.001)  // nowhere a jump
    EXPECT_LT(distance(missed.at(t).state.pose, missed.at(t + 0.001).state.pose), 0.0015) << t;
}

TEST(Reference, RestsBeforeItsBeginningAndAfterItsEnd)
{
  const Robot robot;
  Random random(kSeed);
  const Trajectory points = random_stretch(random, robot, Mode::lateral);
  const Reference reference = reference_of(robot, points);
  for (const double t : {-1.0, 0.0, points.back().t, points.back().t + 5.0})
  {
    const ReferencePoint rest = reference.at(t);
    const TrajectoryPoint& end = t <= 0.0 ? points.front() : points.back();
    EXPECT_EQ(rest.state.v, 0.0);
    EXPECT_EQ(rest.input.a, 0.0);
    EXPECT_EQ(rest.state.pose.x, end.x);
    EXPECT_EQ(rest.state.phi, end.phi);
  }
}

TEST(Reference, OnePointIsAReferenceThatRests)
{
  const TrajectoryPoint point = {3.0, Mode::parallel, 1.0, 2.0, 0.5, 0.0, 0.7};
  const Reference reference(Robot(), &point, &point + 1);
  EXPECT_EQ(reference.start_time(), reference.end_time());
  EXPECT_EQ(reference.at(3.0).state.pose.y, 2.0);
  EXPECT_EQ(reference.least_phi(), 0.7);
}

}  // namespace
}  // namespace fourwis
