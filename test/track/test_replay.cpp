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
struct Record
{
  std::vector<TrackInput> inputs;
  std::vector<WheelCommand> commands;
};

void drive(Tracker& tracker, IdealBase& base, int steps, Record& record)
{
  for (int k = 0; k < steps; ++k)
  {
    TrackInput input{1000.0 + base.wheels().stamp, 1000.0 + base.wheels().stamp - 0.003, base.pose(), base.wheels()};
    input.wheels.stamp += 1000.0 - 0.001;
    record.inputs.push_back(input);
    record.commands.push_back(tracker.step(input).command);
    base.step(record.commands.back(), kPeriod);
  }
}

TEST(Replay, WhatATrackerAnswersDoesNotDependOnWhatItDidBefore)
{
  const Robot robot;
  IdealBase base(robot, {1.0, 2.0, 0.5});
  Tracker tracker(robot, ideal_options());
  Record record;
  ASSERT_EQ(tracker.accept(trajectory_of(robot, base.pose(), {{Mode::ackermann, 0.2, 1.3}})), "");
  drive(tracker, base, 237, record);
  const std::size_t begin = record.inputs.size();
  drive(tracker, base, 3, record);
  const Trajectory second = trajectory_of(
      robot, base.pose(), {{Mode::lateral, 0.2, -1.5}, {Mode::ackermann, 0.1, 1.0}, {Mode::parallel, 0.7, 1.0}});
  ASSERT_EQ(tracker.accept(second), "");
  drive(tracker, base, 600, record);

  Tracker other(robot, ideal_options());
  for (std::size_t k = begin; k < record.inputs.size(); ++k)
  {
    if (k == begin + 3)
    {
      ASSERT_EQ(other.accept(second), "");
    }
    const WheelCommand command = other.step(record.inputs[k]).command;
    ASSERT_EQ(command.mode, record.commands[k].mode) << "step " << k;
    ASSERT_EQ(command.sequence, record.commands[k].sequence) << "step " << k;
    ASSERT_EQ(command.motion.angle, record.commands[k].motion.angle) << "step " << k;
    ASSERT_EQ(command.motion.speed, record.commands[k].motion.speed) << "step " << k;
  }
  EXPECT_EQ(other.step(record.inputs.back()).state, TrackState::arrived);
}

}  // namespace
}  // namespace fourwis
