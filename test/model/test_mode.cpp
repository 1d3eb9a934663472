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

TEST(Mode, OfAnyNumberIsOneOfTheListOrNone)
{
  for (int number = 0; number < 256; ++number)
  {
    const Mode mode = static_cast<Mode>(number);
    EXPECT_EQ(is_mode(mode), number < static_cast<int>(kModeCount)) << number;
    EXPECT_EQ(kModes[index_of(mode)].mode, is_mode(mode) ? mode : Mode::none) << number;
    EXPECT_STREQ(to_string(mode), kModes[index_of(mode)].name) << number;
    EXPECT_EQ(is_planned(mode), mode_from_string(is_mode(mode) ? to_string(mode) : "").has_value()) << number;
    EXPECT_EQ(is_planned(mode), ModeSet().contains(mode)) << number;
  }
}

TEST(Mode, ThePlannedOnesAreListedByName)
{
  EXPECT_EQ(planned_mode_names(", ", " or "), "ackermann, lateral or parallel");
  EXPECT_EQ(planned_mode_names(",", ","), "ackermann,lateral,parallel");
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
  EXPECT_EQ((ModeSet{Mode::lateral, Mode::parallel}).first(), Mode::lateral);
  EXPECT_EQ((ModeSet{Mode::parallel}).first(), Mode::parallel);
  EXPECT_EQ(ModeSet::none().first(), Mode::none);
  for (const ModeSet& set : all_mode_sets()) EXPECT_TRUE(set.contains(set.first()));
}

TEST(ModeSet, IsTheSameWhateverTheOrderOfInsertion)
{
  EXPECT_TRUE((ModeSet{Mode::parallel, Mode::ackermann}) == (ModeSet{Mode::ackermann, Mode::parallel}));
  const std::vector<ModeSet> sets = all_mode_sets();
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (std::size_t k = 0; k < sets.size(); ++k) EXPECT_EQ(sets[i] == sets[k], i == k);
}

TEST(ModeSet, IsAllPlannedModesUnlessToldOtherwise)
{
  for (Mode mode : kPlannedModes) EXPECT_TRUE(ModeSet().contains(mode));
}

}  // namespace
}  // namespace fourwis
