#include "fourwis_navigation/model/path.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "fourwis_navigation/model/plan.h"

namespace fourwis
{
namespace
{

Path path_of(const std::vector<PathPiece>& pieces)
{
  Path path;
  path.pieces = pieces;
  return path;
}

TEST(Path, WithoutPiecesHasNoLengthAndNoSwitch)
{
  EXPECT_EQ(Path().length(), 0.0);
  EXPECT_EQ(Path().switches(), 0);
}

TEST(Path, IsAsLongAsWhatIsDrivenForwardAndBackward)
{
  const Path path = path_of({{Mode::ackermann, {}, 0.1, 2.0}, {Mode::ackermann, {}, 0.1, -0.5}});
  EXPECT_DOUBLE_EQ(path.length(), 2.5);
}

TEST(Path, SwitchesWhereNeighboursDifferInMode)
{
  const PathPiece ackermann = {Mode::ackermann, {}, 0.0, 1.0}, lateral = {Mode::lateral, {}, 0.0, 1.0};
  EXPECT_EQ(path_of({lateral}).switches(), 0);
  EXPECT_EQ(path_of({ackermann, ackermann, lateral, lateral}).switches(), 1);
  EXPECT_EQ(path_of({ackermann, lateral, ackermann, ackermann, lateral}).switches(), 3);
}

TEST(PlanStatus, HasTheWordsOfTheCommandLine)
{
  std::set<std::string> words;
  for (int k = 0; k <= static_cast<int>(PlanStatus::invalid_input); ++k)
    words.insert(to_string(static_cast<PlanStatus>(k)));
  EXPECT_EQ(words, (std::set<std::string>{"succeeded", "start_in_collision", "goal_in_collision", "goal_unreachable",
                                          "no_path", "timeout", "not_converged", "verification_failed", "cancelled",
                                          "invalid_input"}));
}

}  // namespace
}  // namespace fourwis
