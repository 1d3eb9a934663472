#include <gtest/gtest.h>

#include "../support/grids.h"
#include "fourwis_navigation/referee/referee.h"
#include "referee_script.h"

namespace fourwis
{
namespace
{

/// 3.25 m straight ahead, then 2.25 m sideways to the left, each with 0.25 s of acceleration and of braking.
Script corner()
{
  return Script({1.0, 1.0, 0.0}, Mode::ackermann).drive(1.0, 3.0).switch_to(Mode::lateral, 0.0, 1.0).drive(1.0, 2.0);
}

/// 10 x 6 m with the cells around a place occupied.
Referee with_post(double x, double y)
{
  OccupancyGrid grid = free_grid(200, 120, 0.05);
  occupy(grid, static_cast<int>(x / grid.resolution), static_cast<int>(y / grid.resolution));
  return Referee(grid, {}, {});
}

TEST(VerifyAhead, SeesNothingOnTheGridThatTheTrajectoryWasAcceptedOn)
{
  const Referee free(free_grid(200, 120, 0.05), {}, {});
  const Script script = corner();
  ASSERT_TRUE(free.judge(script.start(), script.end(), script.points()).accepted());
  for (double t = -1.0; t < 10.0; t += 0.07) EXPECT_FALSE(free.first_violation_from(t, script.points())) << "t " << t;
  EXPECT_FALSE(free.first_violation_from(0.0, {}));
}

TEST(VerifyAhead, SeesWhatTheWholeJudgementSeesUntilTheBodyHasPassedIt)
{
  // In the way of the first stretch: the body is above it from 1.125 s on, for 1.05 s.
  const Referee referee = with_post(2.525, 1.0);
  const Script script = corner();
  const Verdict whole = referee.judge(script.start(), script.end(), script.points());
  ASSERT_FALSE(whole.accepted());
  for (const double t : {-1.0, 0.0, 0.1, 0.5, 1.1})
  {
    const auto violation = referee.first_violation_from(t, script.points());
    ASSERT_TRUE(violation) << "t " << t;
    EXPECT_EQ(violation->point, whole.violations.front().point);
    EXPECT_NEAR(violation->t, whole.violations.front().t, 0.011);
  }
  EXPECT_TRUE(referee.first_violation_from(2.15, script.points()));
  for (const double t : {2.2, 3.0, 3.5, 4.0, 5.0, 20.0})
    EXPECT_FALSE(referee.first_violation_from(t, script.points())) << "t " << t;
}

TEST(VerifyAhead, SeesWhatIsBehindASwitch)
{
  const Referee referee = with_post(4.32, 2.52);
  const Script script = corner();
  for (const double t : {0.0, 3.4, 3.6, 4.4, 4.6})  // before, at and after the switch, which lasts from 3.5 s to 4.5 s
  {
    const auto violation = referee.first_violation_from(t, script.points());
    ASSERT_TRUE(violation) << "t " << t;
    EXPECT_GT(violation->t, 4.6);
    EXPECT_NE(violation->what.find("column 86, row 50"), std::string::npos) << violation->what;
  }
}

TEST(VerifyAhead, SeesWhatLiesOnAnArc)
{
  const Script script = Script({2.0, 2.0, 0.0}, Mode::ackermann, 0.3).drive(1.0, 3.0);
  for (double t = 0.0; t < 3.0; t += 0.25)
  {
    const auto hit = with_post(script.end().x, script.end().y).first_violation_from(t, script.points());
    EXPECT_TRUE(hit) << "t " << t;
    EXPECT_FALSE(Referee(free_grid(200, 120, 0.05), {}, {}).first_violation_from(t, script.points())) << "t " << t;
  }
}

}  // namespace
}  // namespace fourwis
