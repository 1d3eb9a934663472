// The control step never allocates or frees memory.

#include <gtest/gtest.h>

#include "../support/allocations.h"
#include "track_fixture.h"

namespace fourwis
{
namespace
{

TEST(TrackerAllocations, AWholeDriveHasNone)
{
  const Robot robot;
  IdealBase base(robot, {});
  Tracker tracker(robot, ideal_options());
  // A stop, a switch, a correction and a failure: all that may happen in a step.
  const Trajectory trajectory =
      trajectory_of(robot, {}, {{Mode::ackermann, 0.2, 1.5}, {Mode::lateral, 0.1, 1.0}, {Mode::parallel, 0.5, 1.0}});
  ASSERT_EQ(tracker.accept(trajectory), "");
  int states[6] = {};
  const long before = allocations;
  EXPECT_GT(before, 0);
  TrackOutput output;
  for (int k = 0; k < 1500; ++k)
  {
    output = tracker.step({base.wheels().stamp, base.wheels().stamp, base.pose(), base.wheels()});
    ++states[static_cast<int>(output.state)];
    base.step(output.command, 0.02);
    if (k == 400) base.push(compose(base.pose(), {0.03, 0.05, 0.05}));
    if (output.state == TrackState::arrived) break;
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_EQ(output.state, TrackState::arrived) << output.message;
  EXPECT_GT(states[static_cast<int>(TrackState::aligning)], 50);
  EXPECT_GT(states[static_cast<int>(TrackState::driving)], 200);
}

TEST(TrackerAllocations, StopsHaveNone)
{
  const Robot robot;
  for (const bool lost : {true, false})
  {
    IdealBase base(robot, {});
    Tracker tracker(robot, ideal_options());
    ASSERT_EQ(tracker.accept(trajectory_of(robot, {}, {{Mode::ackermann, 0.2, 5.0}})), "");
    ASSERT_EQ(tracker.accept(trajectory_of(robot, {}, {{Mode::ackermann, 0.2, 5.0}})), "");
    const long before = allocations;
    for (int k = 0; k < 200; ++k)
    {
      if (k == 100 && !lost) tracker.stop();
      const double pose_stamp = base.wheels().stamp - (k >= 100 && lost ? 1.0 : 0.0);
      base.step(tracker.step({base.wheels().stamp, pose_stamp, base.pose(), base.wheels()}).command, 0.02);
    }
    EXPECT_EQ(allocations - before, 0);
  }
}

}  // namespace
}  // namespace fourwis
