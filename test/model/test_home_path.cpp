#include <gtest/gtest.h>

#include "fourwis_navigation/model/home_path.h"

namespace fourwis
{
namespace
{

class HomePath : public testing::Test
{
protected:
  HomePath() { setenv("HOME", "/people/ada lovelace", 1); }
  ~HomePath() override { setenv("HOME", before_.c_str(), 1); }

  const std::string before_ = std::getenv("HOME") ? std::getenv("HOME") : "";
};

TEST_F(HomePath, ATildeAloneOrBeforeASlashIsTheHomeDirectory)
{
  EXPECT_EQ(expand_home("~"), "/people/ada lovelace");
  EXPECT_EQ(expand_home("~/"), "/people/ada lovelace/");
  EXPECT_EQ(expand_home("~/maps/my map.yaml"), "/people/ada lovelace/maps/my map.yaml");
}

TEST_F(HomePath, EverythingElseStaysAsItIs)
{
  for (const char* path : {"", "-", "map.yaml", "/maps/map.yaml", "~other/map.yaml", "./~/map.yaml", "a~/b", " ~/map"})
    EXPECT_EQ(expand_home(path), path);
}

TEST_F(HomePath, WithoutAHomeDirectoryATildeIsALetter)
{
  setenv("HOME", "", 1);
  EXPECT_EQ(expand_home("~/map.yaml"), "~/map.yaml");
  unsetenv("HOME");
  EXPECT_EQ(expand_home("~/map.yaml"), "~/map.yaml");
}

}  // namespace
}  // namespace fourwis
