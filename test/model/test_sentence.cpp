#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{
namespace
{

TEST(Sentence, IsPrintf)
{
  EXPECT_EQ(sentence("%d of %.2f m %s", 3, 1.5, "left"), "3 of 1.50 m left");
  EXPECT_EQ(sentence("nothing to fill in"), "nothing to fill in");
  EXPECT_EQ(sentence(""), "");
}

TEST(Sentence, IsNeverCut)
{
  const std::string text(10000, 'x');
  EXPECT_EQ(sentence("<%s>", text.c_str()), "<" + text + ">");
}

TEST(Sentence, JoinsParts)
{
  EXPECT_EQ(joined("speed is ", 1.25, " m/s, expected at most ", 1), "speed is 1.25 m/s, expected at most 1");
}

TEST(Reject, ThrowsTheErrorAskedForWithTheSentence)
{
  std::string text;
  try
  {
    reject<std::out_of_range>("wheel is ", 7, ", expected 0 to 3");
  }
  catch (const std::out_of_range& error)
  {
    text = error.what();
  }
  EXPECT_EQ(text, "wheel is 7, expected 0 to 3");
}

}  // namespace
}  // namespace fourwis
