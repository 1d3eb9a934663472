#include "search/motion_cost.h"

#include <gtest/gtest.h>

#include "../support/random.h"

namespace fourwis
{
namespace
{

constexpr double kAccuracy = 1e-12;
constexpr double kFull = M_PI / 6.0;  ///< phi_max of the paper's robot [rad]

/// The paper's Table I: v_ref 1 m/s, dt 0.5 s, t_switch 0.4 s, a_max 5 m/s^2, C_rev 2, C_steer, C_dsteer and C_dir 1.
struct PaperCost : testing::Test
{
  double piece(Mode mode, double phi, double length) const
  {
    return MotionCost(robot, options).piece({mode, {}, phi, length}, nullptr);
  }
  double after(const PathPiece& previous, Mode mode, double phi, double length) const
  {
    return MotionCost(robot, options).piece({mode, {}, phi, length}, &previous);
  }
  double mode_switch(bool at_start = false) const { return MotionCost(robot, options).mode_switch(at_start); }

  Robot robot;
  SearchOptions options;
  const PathPiece straight = {Mode::ackermann, {}, 0.0, 0.5};
};

TEST_F(PaperCost, ASwitchCostsItsTimeAndStoppingAndStarting)
{
  EXPECT_NEAR(mode_switch(), 0.4 + 0.2, kAccuracy);
}

TEST_F(PaperCost, ASwitchAtTheStartSavesTheStopping)
{
  EXPECT_NEAR(mode_switch(true), 0.4 + 0.1, kAccuracy);
}

TEST_F(PaperCost, ASwitchCostsMoreTheFasterTheRobotGoes)
{
  options.reference_speed = 2.0;
  EXPECT_NEAR(mode_switch(), 0.8 + 0.8, kAccuracy);
  EXPECT_NEAR(mode_switch(true), 0.8 + 0.4, kAccuracy);
}

TEST_F(PaperCost, ASwitchIsFreeWithoutSwitchingAwareness)
{
  options.switching_awareness = false;
  EXPECT_EQ(mode_switch(), 0.0);
  EXPECT_EQ(mode_switch(true), 0.0);
}

TEST_F(PaperCost, StraightForwardMotionCostsItsLength)
{
  for (Mode mode : kPlannedModes) EXPECT_NEAR(piece(mode, 0.0, 0.5), 0.5, kAccuracy) << to_string(mode);
}

TEST_F(PaperCost, SteeringCostsByTheRadianForEachPrimitive)
{
  for (Mode mode : {Mode::ackermann, Mode::lateral})
  {
    EXPECT_NEAR(piece(mode, kFull, 0.5), 0.5 + M_PI / 6.0, kAccuracy);
    EXPECT_NEAR(piece(mode, -kFull, 1.0), 1.0 + 2.0 * M_PI / 6.0, kAccuracy);
  }
}

TEST_F(PaperCost, ReversingCostsForEachPrimitiveDrivenBackward)
{
  EXPECT_NEAR(piece(Mode::ackermann, 0.0, -0.5), 0.5 + 2.0, kAccuracy);
  EXPECT_NEAR(piece(Mode::ackermann, 0.0, -0.25), 0.25 + 1.0, kAccuracy);
  EXPECT_NEAR(piece(Mode::parallel, 0.0, -0.5), 0.5 + 2.0, kAccuracy);
}

TEST_F(PaperCost, LateralMotionToTheRightIsNotReversingUnlessToldSo)
{
  EXPECT_NEAR(piece(Mode::lateral, 0.0, -0.5), 0.5, kAccuracy);
  options.lateral_reverse_penalty = 2.0;
  EXPECT_NEAR(piece(Mode::lateral, 0.0, -0.5), 0.5 + 2.0, kAccuracy);
}

TEST_F(PaperCost, TheDirectionOfParallelMotionIsFreeUnlessToldOtherwise)
{
  EXPECT_NEAR(piece(Mode::parallel, 1.2, 0.5), 0.5, kAccuracy);
  options.parallel_steering_penalty = 1.0;
  EXPECT_NEAR(piece(Mode::parallel, 1.2, 0.5), 0.5 + 1.2, kAccuracy);
}

TEST_F(PaperCost, TurningTheWheelsCostsByTheRadian)
{
  EXPECT_NEAR(after(straight, Mode::ackermann, kFull, 0.5), 0.5 + M_PI / 6.0 + M_PI / 6.0, kAccuracy);
  const PathPiece left = {Mode::ackermann, {}, kFull, 0.5};
  EXPECT_NEAR(after(left, Mode::ackermann, -kFull, 0.5), 0.5 + M_PI / 6.0 + 2.0 * M_PI / 6.0, kAccuracy);
}

TEST_F(PaperCost, AChangeOfDirectionCostsOnce)
{
  EXPECT_NEAR(after(straight, Mode::ackermann, 0.0, -0.5), 0.5 + 2.0 + 1.0, kAccuracy);
  const PathPiece backward = {Mode::ackermann, {}, 0.0, -0.5};
  EXPECT_NEAR(after(backward, Mode::ackermann, 0.0, 0.5), 0.5 + 1.0, kAccuracy);
  EXPECT_NEAR(after(backward, Mode::ackermann, 0.0, -0.5), 0.5 + 2.0, kAccuracy);
}

TEST_F(PaperCost, NothingIsCarriedOverFromAnotherMode)
{
  const PathPiece backward = {Mode::lateral, {}, -kFull, -0.5};
  EXPECT_EQ(after(backward, Mode::ackermann, kFull, 0.5), piece(Mode::ackermann, kFull, 0.5));
}

TEST_F(PaperCost, OfAPieceIsThatOfItsParts)
{
  Random random(6);
  const MotionCost cost(robot, options);
  for (int k = 0; k < 1000; ++k)
  {
    const Mode mode = random.mode();
    const PathPiece whole = {mode, {}, random.steering(robot, mode), random.between(-3.0, 3.0)};
    const PathPiece before = {mode, {}, random.steering(robot, mode), random.between(-3.0, 3.0)};
    const double share = random.between(0.01, 0.99);
    PathPiece first = whole, second = whole;
    first.length *= share;
    second.length *= 1.0 - share;
    ASSERT_NEAR(cost.piece(first, &before) + cost.piece(second, &first), cost.piece(whole, &before), 1e-9);
  }
}

TEST_F(PaperCost, IsNeverLessThanTheLength)
{
  Random random(7);
  const MotionCost cost(robot, options);
  for (int k = 0; k < 1000; ++k)
  {
    const Mode mode = random.mode();
    const PathPiece before = {random.mode(), {}, random.angle(), random.between(-3.0, 3.0)};
    const PathPiece piece = {mode, {}, random.steering(robot, mode), random.between(-3.0, 3.0)};
    ASSERT_GE(cost.piece(piece, &before), std::abs(piece.length));
  }
}

}  // namespace
}  // namespace fourwis
