#include "fourwis_navigation/model/mode_colour.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace fourwis
{
namespace
{

TEST(ModeColour, IsAnotherForEachMode)
{
  std::set<std::tuple<int, int, int>> colours;
  for (const ModeName& entry : kModes)
  {
    const Colour& colour = colour_of(entry.mode);
    EXPECT_TRUE(colours.emplace(colour.red, colour.green, colour.blue).second) << entry.name;
  }
}

TEST(ModeColour, OfWhatIsNoModeIsThatOfNone)
{
  EXPECT_EQ(&colour_of(static_cast<Mode>(200)), &colour_of(Mode::none));
}

}  // namespace
}  // namespace fourwis
