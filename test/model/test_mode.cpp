#include "fourwis_navigation/model/mode.h"

#include <gtest/gtest.h>

#include <set>

#include "../support/random.h"

namespace fourwis
{
namespace
{

constexpr Mode kAllModes[] = {Mode::none, Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin};

TEST(Mode, HasTheNumbersOfTheMessages)
{
  EXPECT_EQ(static_cast<int>(Mode::none), 0);
  EXPECT_EQ(static_cast<int>(Mode::ackermann), 1);
  EXPECT_EQ(static_cast<int>(Mode::lateral), 2);
  EXPECT_EQ(static_cast<int>(Mode::parallel), 3);
  EXPECT_EQ(static_cast<int>(Mode::spin), 4);
}

TEST(Mode, HasANameOfItsOwn)
{
  std::set<std::string> names;
  for (Mode mode : kAllModes) names.insert(to_string(mode));
  EXPECT_EQ(names, (std::set<std::string>{"none", "ackermann", "lateral", "parallel", "spin"}));
}

TEST(Mode, IsFoundByItsNameIfItIsPlanned)
{
  for (Mode mode : kPlannedModes) EXPECT_EQ(mode_from_string(to_string(mode)), mode);
}

TEST(Mode, IsNotFoundByAnyOtherName)
{
  for (const char* name : {"", "none", "spin", "Ackermann", "ackermann ", " lateral", "paralell", "1"})
    EXPECT_FALSE(mode_from_string(name)) << name;
}

TEST(ModeSet, HoldsExactlyWhatWasInserted)
{
  for (int bits = 0; bits < 8; ++bits)
  {
    ModeSet modes = ModeSet::none();
    for (std::size_t k = 0; k < kPlannedModes.size(); ++k)
      if (bits >> k & 1) modes.insert(kPlannedModes[k]);
    for (std::size_t k = 0; k < kPlannedModes.size(); ++k)
      EXPECT_EQ(modes.contains(kPlannedModes[k]), (bits >> k & 1) == 1) << text(modes);
    EXPECT_EQ(modes.empty(), bits == 0);
  }
}

TEST(ModeSet, NeverHoldsAModeThatIsNotPlanned)
{
  ModeSet modes = ModeSet::none();
  modes.insert(Mode::none);
  modes.insert(Mode::spin);
  EXPECT_TRUE(modes.empty());
  for (const ModeSet& set : all_mode_sets())
  {
    EXPECT_FALSE(set.contains(Mode::none));
    EXPECT_FALSE(set.contains(Mode::spin));
  }
}

TEST(ModeSet, StartsWithItsFirstModeInTheOrderOfTies)
{
  EXPECT_EQ(ModeSet().first(), Mode::ackermann);
  EXPECT_EQ((ModeSet{false, true, true}).first(), Mode::lateral);
  EXPECT_EQ((ModeSet{false, false, true}).first(), Mode::parallel);
  EXPECT_EQ(ModeSet::none().first(), Mode::none);
  for (const ModeSet& set : all_mode_sets()) EXPECT_TRUE(set.contains(set.first()));
}

TEST(ModeSet, IsAllPlannedModesUnlessToldOtherwise)
{
  for (Mode mode : kPlannedModes) EXPECT_TRUE(ModeSet().contains(mode));
}

}  // namespace
}  // namespace fourwis
