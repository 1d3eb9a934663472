#include <algorithm>
#include <cstdio>
#include <fstream>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{
namespace
{

/// A key that may be any of the table's numbers.
const std::string kKey = "wheel_max_rate";

struct Row
{
  std::string written, sent;
  std::optional<double> meaning;
};

std::vector<Row> table()
{
  std::vector<Row> rows;
  std::ifstream file(FOURWIS_SOURCE_DIR "/test/parameters/yaml_values.txt");
  const std::regex columns("(.+) \\| (.+) \\| (.+)");
  std::smatch row;
  for (std::string line; std::getline(file, line);)
  {
    if (line.front() == '#' || !std::regex_match(line, row, columns)) continue;
    const std::string meaning = row[3];
    rows.push_back({row[1], row[2], meaning == "-" ? std::nullopt : std::make_optional(std::stod(meaning))});
  }
  return rows;
}

/// What roslaunch puts on the parameter server; none where it puts no value there.
std::optional<ParameterValue> value_of(const std::string& sent)
{
  const std::string type = sent.substr(0, sent.find(' '));
  const std::string value = sent.substr(std::min(sent.size(), type.size() + 1));
  if (type == "number") return std::stod(value);
  if (type == "flag") return value == "true";
  if (type == "text") return value;
  return std::nullopt;
}

/// The value that `read` gives the key; none where it is refused, which has to be by name.
template <class Read>
std::optional<double> meaning_of(const Read& read)
{
  try
  {
    return read().wheel_max_rate;
  }
  catch (const ConfigError& error)
  {
    EXPECT_NE(std::string(error.what()).find(kKey), std::string::npos) << error.what();
    return std::nullopt;
  }
}

TEST(YamlValues, AreManyInTheTable)
{
  EXPECT_GT(table().size(), 50u);
}

TEST(YamlValues, MeanTheSameInAFile)
{
  const std::string path = testing::TempDir() + "fourwis_yaml_values.yaml";
  for (const Row& row : table())
  {
    std::ofstream(path) << kKey << ": " << row.written << '\n';
    EXPECT_EQ(meaning_of([&] { return read_robot_file(path); }), row.meaning) << row.written;
  }
  std::remove(path.c_str());
}

TEST(YamlValues, MeanTheSameToANode)
{
  for (const Row& row : table())
  {
    const auto value = value_of(row.sent);
    if (!value) continue;
    EXPECT_EQ(meaning_of([&] { return robot_from({{kKey, *value}}); }), row.meaning) << row.written;
  }
}

}  // namespace
}  // namespace fourwis
