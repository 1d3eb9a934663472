#include <gtest/gtest.h>

#include "fourwis_navigation/track/step_number.h"
#include "track_fixture.h"

namespace fourwis
{
namespace
{

constexpr double kPeriod = 0.02;

TEST(Replay, ControlStepsAreNumberedByTheClockWithRoomForJitter)
{
  for (const double start : {0.0, 1000.0, 1.8e9})
    for (int k = 1; k < 1000; ++k)
      for (const double jitter : {-4e-4, 0.0, 4e-4, 0.01})
        ASSERT_EQ(step_number(start + k * kPeriod + jitter, 50.0) - step_number(start, 50.0), static_cast<unsigned>(k));
  EXPECT_EQ(step_number(-5.0, 50.0), 0u);
  EXPECT_EQ(step_number(NAN, 50.0), 0u);
  EXPECT_EQ(step_number(INFINITY, 50.0), 0u);
}

/// All inputs and answers of a tracker.
struct Life
{
  std::vector<TrackInput> inputs;
  std::vector<WheelCommand> commands;
};

void live(Tracker& tracker, IdealBase& base, int steps, Life& life)
{
  for (int k = 0; k < steps; ++k)
  {
    TrackInput input{1000.0 + base.wheels().stamp, 1000.0 + base.wheels().stamp - 0.003, base.pose(), base.wheels()};
    input.wheels.stamp += 1000.0 - 0.001;
    life.inputs.push_back(input);
    life.commands.push_back(tracker.step(input).command);
    base.step(life.commands.back(), kPeriod);
  }
}

TEST(Replay, WhatATrackerAnswersDoesNotDependOnWhatItDidBefore)
{
  const Robot robot;
  IdealBase base(robot, {1.0, 2.0, 0.5});
  Tracker tracker(robot, ideal_options());
  Life life;
  ASSERT_EQ(tracker.accept(trajectory_of(robot, base.pose(), {{Mode::ackermann, 0.2, 1.3}})), "");
  live(tracker, base, 237, life);
  const std::size_t begin = life.inputs.size();
  live(tracker, base, 3, life);
  const Trajectory second = trajectory_of(
      robot, base.pose(), {{Mode::lateral, 0.2, -1.5}, {Mode::ackermann, 0.1, 1.0}, {Mode::parallel, 0.7, 1.0}});
  ASSERT_EQ(tracker.accept(second), "");
  live(tracker, base, 600, life);

  Tracker other(robot, ideal_options());
  for (std::size_t k = begin; k < life.inputs.size(); ++k)
  {
    if (k == begin + 3)
    {
      ASSERT_EQ(other.accept(second), "");
    }
    const WheelCommand command = other.step(life.inputs[k]).command;
    ASSERT_EQ(command.mode, life.commands[k].mode) << "step " << k;
    ASSERT_EQ(command.sequence, life.commands[k].sequence) << "step " << k;
    ASSERT_EQ(command.motion.angle, life.commands[k].motion.angle) << "step " << k;
    ASSERT_EQ(command.motion.speed, life.commands[k].motion.speed) << "step " << k;
  }
  EXPECT_EQ(other.step(life.inputs.back()).state, TrackState::arrived);
}

}  // namespace
}  // namespace fourwis
