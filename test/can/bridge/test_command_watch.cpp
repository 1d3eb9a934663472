#include "can/bridge/command_watch.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace fourwis::can
{
namespace
{

using Verdict = CommandWatch::Verdict;

WheelCommand command(std::uint32_t sequence)
{
  WheelCommand command;
  command.mode = Mode::ackermann;
  command.sequence = sequence;
  return command;
}

class Commands : public testing::Test
{
protected:
  CommandWatch watch_{Robot(), BridgeOptions()};
};

TEST_F(Commands, ExpireAfterTheTimeoutAndOnlyIfThereWasOne)
{
  EXPECT_FALSE(watch_.expired(1e9));
  EXPECT_EQ(watch_.take(command(1), 10.0, 10.0), Verdict::taken);
  EXPECT_FALSE(watch_.expired(10.149));
  EXPECT_TRUE(watch_.expired(10.1501));
  watch_.reset();
  EXPECT_FALSE(watch_.expired(1e9));
  EXPECT_EQ(watch_.newest().mode, Mode::none);
}

TEST_F(Commands, OvertakenOnesAreNotTakenAndFeedNoWatchdog)
{
  EXPECT_EQ(watch_.take(command(5), 0.0, 0.0), Verdict::taken);
  EXPECT_EQ(watch_.take(command(4), 0.1, 0.1), Verdict::overtaken);
  EXPECT_EQ(watch_.take(command(5), 0.1, 0.1), Verdict::overtaken);
  EXPECT_TRUE(watch_.expired(0.16));
  EXPECT_EQ(watch_.newest().sequence, 5u);
}

TEST_F(Commands, ExpireByTheTimeWhenTheyWereMade)
{
  EXPECT_EQ(watch_.take(command(1), 10.0, 10.08), Verdict::taken);
  EXPECT_FALSE(watch_.expired(10.149));
  EXPECT_TRUE(watch_.expired(10.1501));
}

TEST_F(Commands, ThatAreTooOldAreNotTakenAndFeedNoWatchdog)
{
  EXPECT_EQ(watch_.take(command(1), 10.0, 10.16), Verdict::late);
  EXPECT_FALSE(watch_.expired(1e9));
  EXPECT_EQ(watch_.take(command(1), 20.0, 20.0), Verdict::taken);
  EXPECT_EQ(watch_.take(command(2), 20.0, 20.151), Verdict::late);
  EXPECT_EQ(watch_.newest().sequence, 1u);
}

TEST_F(Commands, TheSequenceWrapsAroundAndMayBeginAnew)
{
  EXPECT_EQ(watch_.take(command(0xFFFFFFFF), 0.0, 0.0), Verdict::taken);
  EXPECT_EQ(watch_.take(command(0), 0.01, 0.01), Verdict::taken);
  EXPECT_EQ(watch_.take(command(5000), 0.02, 0.02), Verdict::taken);
  EXPECT_EQ(watch_.take(command(1), 0.03, 0.03), Verdict::taken);
}

TEST_F(Commands, ASequenceThatIsFarBehindIsThatOfANewSender)
{
  EXPECT_EQ(watch_.take(command(1000), 0.0, 0.0), Verdict::taken);
  EXPECT_EQ(watch_.take(command(901), 0.01, 0.01), Verdict::overtaken) << "99 behind";
  EXPECT_EQ(watch_.take(command(900), 0.01, 0.01), Verdict::taken);
}

TEST_F(Commands, AfterOneThatIsExpiredOrForgottenAnySequenceIsTaken)
{
  EXPECT_EQ(watch_.take(command(5), 0.0, 0.0), Verdict::taken);
  EXPECT_EQ(watch_.take(command(4), 0.16, 0.16), Verdict::taken);
  watch_.reset();
  EXPECT_EQ(watch_.take(command(4), 0.17, 0.17), Verdict::taken);
}

TEST_F(Commands, NonsenseIsRefused)
{
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), inf, -inf})
    for (std::size_t i = 0; i < kWheels; ++i)
    {
      WheelCommand angle = command(1), speed = command(1);
      angle.motion.angle[i] = bad;
      speed.motion.speed[i] = bad;
      EXPECT_EQ(watch_.take(angle, 0.0, 0.0), Verdict::invalid);
      EXPECT_EQ(watch_.take(speed, 0.0, 0.0), Verdict::invalid);
      angle.mode = Mode::none;  // a command to stop is valid with any angles
      EXPECT_EQ(watch_.take(angle, 0.0, 0.0), Verdict::taken);
      watch_.reset();
    }
  WheelCommand beyond = command(1);
  beyond.motion.angle[2] = Robot().wheel_max_angle + 0.01;
  EXPECT_EQ(watch_.take(beyond, 0.0, 0.0), Verdict::invalid);
  WheelCommand unknown = command(1);
  unknown.mode = static_cast<Mode>(5);
  EXPECT_EQ(watch_.take(unknown, 0.0, 0.0), Verdict::invalid);
}

}  // namespace
}  // namespace fourwis::can
