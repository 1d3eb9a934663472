#include "fourwis_navigation/parameters/documentation.h"

#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "../support/sentences.h"
#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{
namespace
{

TEST(ParameterDocumentation, IsTheFileThatIsShipped)
{
  std::ifstream file(FOURWIS_SOURCE_DIR "/doc/parameters.md");
  const std::string shipped{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(parameter_documentation(), shipped) << "make it anew: plan --list-parameters > doc/parameters.md";
}

TEST(ParameterDocumentation, HasEveryKeyOfEveryConfigurationFile)
{
  const std::string text = parameter_documentation();
  for (const std::string name : {"robot", "planner", "mpc", "can_bridge", "simulator", "global_planner",
                                 "mpc_controller", "can_bridge_node", "base_simulator"})
  {
    const std::string file = "config/" + name + ".yaml";
    const std::size_t begin = text.find("## " + file + "\n");
    ASSERT_NE(begin, std::string::npos) << file;
    const std::string section = text.substr(begin, text.find("\n## ", begin) - begin);
    for (const auto& [key, value] : read_parameter_file(FOURWIS_SOURCE_DIR "/" + file))
      EXPECT_TRUE(says(section, "\n| `" + key + "` | ")) << file;
  }
}

TEST(ParameterDocumentation, SaysWhatAKeyIsAndMayBe)
{
  const std::string text = parameter_documentation();
  EXPECT_TRUE(says(text, "| `step_time` | from the robot's size and turns | 0.01 to 10 | s |"));
  EXPECT_TRUE(says(text, "| `max_expansions` | 200000 | 1 to 1e+09 |  |"));
  EXPECT_TRUE(says(text, "| `switching_awareness` | true | true, false |  |"));
  EXPECT_TRUE(says(text, "| `solver` | structured | one of structured, ipopt |  |"));
  EXPECT_TRUE(says(text, "| `driving/rear_left/node` | 7 | 1 to 127 |  |"));
}

}  // namespace
}  // namespace fourwis
