#include "fourwis_navigation/track/tracker.h"

#include <gtest/gtest.h>

#include "track_fixture.h"

namespace fourwis
{
namespace
{

TEST(Tracker, IdealWheelsKeepToTheTrajectory)
{
  const Robot robot;
  for (const std::vector<Piece>& pieces : std::vector<std::vector<Piece>>{
         {{Mode::ackermann, 0.0, 3.0}},
         {{Mode::ackermann, 0.3, 2.0}},
         {{Mode::ackermann, 0.3, 1.0}, {Mode::ackermann, -0.3, -1.0}},
         {{Mode::lateral, 0.2, -1.5}, {Mode::ackermann, 0.1, 1.0}, {Mode::parallel, 0.7, 1.0}}})
  {
    const Pose start = {1.0, 2.0, 0.5};
    Tracker tracker(robot, ideal_options());
    IdealBase base(robot, start);
    EXPECT_EQ(tracker.accept(trajectory_of(robot, start, pieces)), "");
    const Drive result = drive(tracker, base);
    EXPECT_EQ(result.state, TrackState::arrived) << result.message;
    std::printf("%d %s %.2f s, lat %.2f lon %.2f mm, %.3f rad\n", int(result.state), result.message.c_str(), result.seconds,
                1e3 * result.worst_lateral, 1e3 * result.worst_longitudinal, result.worst_heading);
  }
}

}  // namespace
}  // namespace fourwis
