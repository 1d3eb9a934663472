#include "track/check_trajectory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "random_stretch.h"
#include "track_fixture.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 45;

TEST(CheckTrajectory, WhatThePlannerMakesIsAccepted)
{
  const Robot robot;
  Random random(kSeed);
  for (int trial = 0; trial < 100; ++trial)
  {
    std::vector<Piece> pieces;
    for (int k = random.whole(1, 5); k > 0; --k)
    {
      const Mode mode = random.mode();
      pieces.push_back({mode, random.steering(robot, mode), random.between(-2.0, 2.0)});
    }
    EXPECT_EQ(check_trajectory(robot, trajectory_of(robot, random.pose(5.0), pieces)), "")
        << "seed " << kSeed << ", trial " << trial;
    EXPECT_EQ(check_trajectory(robot, random_stretch(random, robot, random.mode())), "")
        << "seed " << kSeed << ", trial " << trial;
  }
}

TEST(CheckTrajectory, WhatCannotBeDrivenIsRefusedByPointAndReason)
{
  struct Case
  {
    const char* says;
    std::function<void(Trajectory&)> spoil;
  };
  const std::vector<Case> cases = {
      {"point 3: holds something that is no finite number", [](Trajectory& t) { t[3].x = NAN; }},
      {"point 3: holds something that is no finite number", [](Trajectory& t) { t[3].theta = INFINITY; }},
      {"point 3: holds something that is no finite number", [](Trajectory& t) { t[3].v = NAN; }},
      {"point 3: holds something that is no finite number", [](Trajectory& t) { t[3].phi = -INFINITY; }},
      {"point 3: holds something that is no finite number", [](Trajectory& t) { t[3].t = NAN; }},
      {"point 2: its mode is not known", [](Trajectory& t) { t[2].mode = Mode::none; }},
      {"point 2: its mode is not known", [](Trajectory& t) { t[2].mode = Mode::spin; }},
      {"point 2: its mode is not known", [](Trajectory& t) { t[2].mode = Mode(99); }},
      {"point 4: its time is not later than the one before", [](Trajectory& t) { t[4].t = t[3].t; }},
      {"point 4: it lies more than an hour ahead",
       [](Trajectory& t) {
         for (std::size_t k = 4; k < t.size(); ++k) t[k].t += 4000.0;
       }},
      {"point 4: faster than max_speed", [](Trajectory& t) { t[4].v = 1.01; }},
      {"point 4: steers more than the robot can", [](Trajectory& t) { t[4].phi = 0.6; }},
      {"point 0: is not at rest", [](Trajectory& t) { t[0].v = 0.1; }},
      {": is not at rest", [](Trajectory& t) { t.back().v = 0.1; }},
      {"point 4: is not at rest at a switch",
       [](Trajectory& t) {
         for (std::size_t k = 0; k <= 4; ++k) t[k].mode = Mode::parallel;
       }},
      {"accelerates more than max_acceleration", [](Trajectory& t) { t[4].v = 0.2; }},
      {"point 4: its motion misses the next point",
       [](Trajectory& t) {
         for (std::size_t k = 5; k < t.size(); ++k) t[k].y += 0.006;
       }},
      {"point 4: its motion misses the next heading",
       [](Trajectory& t) {
         for (std::size_t k = 5; k < t.size(); ++k) t[k].theta += 0.011;
       }},
  };
  const Robot robot;
  const Trajectory good = trajectory_of(robot, {}, {{Mode::ackermann, 0.0, 2.0}});
  ASSERT_GT(good.size(), 8u);
  for (const Case& spoiled : cases)
  {
    Trajectory trajectory = good;
    spoiled.spoil(trajectory);
    const std::string complaint = check_trajectory(robot, trajectory);
    EXPECT_NE(complaint.find(spoiled.says), std::string::npos) << spoiled.says << " -> " << complaint;
  }
}

TEST(CheckTrajectory, ASwitchKeepsThePose)
{
  const Robot robot;
  Trajectory trajectory = trajectory_of(robot, {}, {{Mode::ackermann, 0.0, 1.0}, {Mode::lateral, 0.0, 1.0}});
  EXPECT_EQ(check_trajectory(robot, trajectory), "");
  for (TrajectoryPoint& point : trajectory)
    if (point.mode == Mode::lateral) point.x += 0.01;
  EXPECT_NE(check_trajectory(robot, trajectory).find("does not keep its pose at a switch"), std::string::npos);
}

/// To turn the wheels from full lock to full lock takes time.
TEST(CheckTrajectory, SteeringRateIsALimit)
{
  const Robot robot;
  const Trajectory trajectory = {{0.0, Mode::ackermann, 0.0, 0.0, 0.0, 0.0, -0.5},
                                 {0.1, Mode::ackermann, 0.0, 0.0, 0.0, 0.0, 0.5}};
  EXPECT_NE(check_trajectory(robot, trajectory).find("steers faster than max_steering_rate"), std::string::npos);
}

}  // namespace
}  // namespace fourwis
