#include "can/bridge/stop_button.h"

#include <vector>

#include <gtest/gtest.h>

namespace fourwis::can
{
namespace
{

class Button : public testing::Test
{
protected:
  using Calls = std::vector<bool>;

  Calls pass_on()
  {
    Calls calls;
    button_.pass_on([&](bool pressed) { calls.push_back(pressed); });
    return calls;
  }

  StopButton button_;
};

TEST_F(Button, IsObeyedOnceForEachChange)
{
  EXPECT_EQ(pass_on(), Calls());
  button_.set(true);
  EXPECT_EQ(pass_on(), Calls{true});
  EXPECT_EQ(pass_on(), Calls());
  button_.set(false);
  EXPECT_EQ(pass_on(), Calls{false});
  EXPECT_EQ(pass_on(), Calls());
}

TEST_F(Button, PressedAndReleasedBetweenTwoLooksItWasPressed)
{
  button_.set(true);
  button_.set(false);
  EXPECT_EQ(pass_on(), (Calls{true, false}));
}

TEST_F(Button, ReleasedAndPressedBetweenTwoLooksItIsPressedAnew)
{
  button_.set(true);
  pass_on();
  button_.set(false);
  button_.set(true);
  EXPECT_EQ(pass_on(), Calls{true});
}

TEST_F(Button, ReleasedWithoutHavingBeenPressedNothingHappens)
{
  button_.set(false);
  EXPECT_EQ(pass_on(), Calls());
}

}  // namespace
}  // namespace fourwis::can
