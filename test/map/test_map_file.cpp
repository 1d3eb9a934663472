#include "fourwis_navigation/map/map_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/grids.h"
#include "map_fixture.h"

namespace fourwis
{
namespace
{

using MapFile = MapFixture;

/// map_server's formulas, written down separately.
int value_by_formula(int grey, bool negate, const std::string& mode)
{
  const int level = negate ? 255 - grey : grey;
  if (mode == "raw") return level < 128 ? level : level - 256;
  const double p = (255 - level) / 255.0;
  if (p > 0.65) return 100;
  if (p < 0.196) return 0;
  return mode == "scale" ? static_cast<int>(std::floor(1 + 98 * (p - 0.196) / (0.65 - 0.196))) : -1;
}

TEST_F(MapFile, TakesTheImagesLowestRowAsTheGridsFirst)
{
  const OccupancyGrid grid = read_image_bytes(small_pgm);
  EXPECT_EQ(grid.width, 3);
  EXPECT_EQ(grid.height, 2);
  EXPECT_EQ(grid.data, small_cells);
}

TEST_F(MapFile, TakesResolutionAndOriginWithYawFromTheYaml)
{
  const OccupancyGrid grid = read_image_bytes(small_pgm);
  EXPECT_EQ(grid.resolution, 0.05);
  EXPECT_EQ(grid.origin.x, -1.0);
  EXPECT_EQ(grid.origin.y, 2.5);
  EXPECT_EQ(grid.origin.theta, 0.3);
}

TEST_F(MapFile, GivesEveryGreyLevelMapServersValueInEveryMode)
{
  std::string all;
  for (int grey = 0; grey < 256; ++grey) all += static_cast<char>(grey);
  for (const std::string mode : {"trinary", "scale", "raw"})
  {
    for (const bool negate : {false, true})
    {
      const OccupancyGrid grid = read_image_bytes(pgm(256, 1, all), {{"mode", mode}, {"negate", negate ? "1" : "0"}});
      for (int grey = 0; grey < 256; ++grey)
        EXPECT_EQ(grid.at(grey, 0), value_by_formula(grey, negate, mode)) << mode << negate << " grey " << grey;
    }
  }
}

TEST_F(MapFile, AcceptsNumbersAndWordsForNegate)
{
  for (const char* yes : {"1", "true"}) EXPECT_EQ(read_image_bytes(small_pgm, {{"negate", yes}}).at(2, 0), 0) << yes;
  for (const char* no : {"0", "false"}) EXPECT_EQ(read_image_bytes(small_pgm, {{"negate", no}}).at(2, 0), 100) << no;
}

TEST_F(MapFile, FindsAnImageByItsAbsolutePath)
{
  EXPECT_EQ(read_image_bytes(small_pgm, {{"image", folder_ / "map.pgm"}}).data, small_cells);
}

TEST_F(MapFile, AcceptsEqualThresholdsInEveryMode)
{
  for (const char* mode : {"trinary", "scale"})
  {
    const OccupancyGrid grid = read_image_bytes(pgm(3, 1, "\x33\xcc\xff"),
                                                {{"occupied_thresh", "0.2"}, {"free_thresh", "0.2"}, {"mode", mode}});
    EXPECT_EQ(grid.data, (std::vector<std::int8_t>{100, -1, 0})) << mode;
  }
}

TEST_F(MapFile, RejectsADefectiveFieldByItsName)
{
  write_bytes(folder_ / "map.pgm", small_pgm);
  const std::vector<std::pair<std::string, std::vector<std::string>>> defects{
      {"image", {"", "[a]", "\"\"", "absent.pgm", ".", "map.yaml"}},
      {"resolution", {"", "wide", "0", "-0.05", ".inf", ".nan", "[0.05]", "~", "0.05m", "1e999"}},
      {"origin", {"", "0", "[0, 0]", "[0, 0, 0, 0]", "[0, x, 0]", "[0, .nan, 0]", "{x: 0, y: 0, yaw: 0}"}},
      {"negate", {"", "2", "-1", "maybe", "[0]"}},
      {"occupied_thresh", {"", "high", "1.01", "-0.1", ".nan", "0.1"}},
      {"free_thresh", {"", "low", "-0.01", "1.5"}},
      {"mode", {"Trinary", "ternary", "~", "[raw]", "\"\""}}};
  for (const auto& [field, values] : defects)
  {
    for (const std::string& value : values)
    {
      const std::string path = write_yaml({{field, value}});
      const std::string message = message_of([&path = path] { read_map_file(path); });
      EXPECT_EQ(message.rfind(path + ": " + field + ": ", 0), 0U) << field << ": " << value << " gives " << message;
      EXPECT_NE(message.find("expected"), std::string::npos) << message;
    }
  }
}

TEST_F(MapFile, RejectsWhatIsNotAMapFile)
{
  EXPECT_NE(message_of([&] { read_map_file(folder_ / "absent.yaml"); }), "");
  EXPECT_NE(message_of([&] { read_map_file(folder_ / "."); }), "");
  for (const std::string& text : {std::string(), std::string("word"), std::string("[1, 2]"), std::string("a: [1\nb: }"),
                                  std::string(8000, '['), std::string(9000, ' '), std::string(100, '\0')})
  {
    write_bytes(folder_ / "map.yaml", text);
    const std::string message = message_of([&] { read_map_file(folder_ / "map.yaml"); });
    EXPECT_EQ(message.rfind(folder_ / "map.yaml", 0), 0U) << message;
  }
}

TEST_F(MapFile, TellsWhereAThresholdMakesUnseenCellsFree)
{
  const auto warning_of = [&](const std::map<std::string, std::string>& changes, const std::string& image) {
    write_bytes(folder_ / "map.pgm", image);
    std::string warning;
    read_map_file(write_yaml(changes), &warning);
    return warning;
  };
  // What nav2's and slam_toolbox's map savers write.
  const std::map<std::string, std::string> nav2{{"mode", "trinary"}, {"free_thresh", "0.25"}};
  EXPECT_EQ(read_image_bytes(small_pgm, nav2).data, (std::vector<std::int8_t>{0, 0, 100, 100, 0, 0}));
  EXPECT_EQ(warning_of(nav2, small_pgm),
            (folder_ / "map.yaml") +
                ": free_thresh is 0.25, so what map savers write for unseen (grey 205, occupied with 0.1961) becomes "
                "free: 1 of 6 pixels; expected at most 0.196 where these shall stay unknown");
  EXPECT_NE(warning_of({{"mode", "scale"}, {"free_thresh", "0.2"}}, small_pgm), "");
  EXPECT_EQ(warning_of({}, small_pgm), "") << "stays unknown";
  EXPECT_EQ(warning_of({{"free_thresh", "0.196"}}, small_pgm), "") << "stays unknown";
  EXPECT_EQ(warning_of({{"free_thresh", "0.25"}, {"mode", "raw"}}, small_pgm), "") << "no thresholds";
  EXPECT_EQ(warning_of({{"free_thresh", "0.25"}, {"negate", "1"}}, small_pgm), "") << "occupied";
  EXPECT_EQ(warning_of({{"free_thresh", "0.25"}}, pgm(2, 1, "\xfe\xce")), "") << "nothing unseen";
}

TEST_F(MapFile, FindsFileAndImageInTheHomeDirectory)
{
  const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
  std::filesystem::create_directory(folder_ / "my maps");
  setenv("HOME", (folder_ / "my maps").c_str(), 1);
  write_bytes(folder_ / "my maps/map.pgm", small_pgm);
  write_yaml({{"image", "~/map.pgm"}});
  EXPECT_EQ(read_map_file(folder_ / "map.yaml").data, small_cells);
  std::filesystem::rename(folder_ / "map.yaml", folder_ / "my maps/map.yaml");
  EXPECT_EQ(read_map_file("~/map.yaml").data, small_cells);
  EXPECT_EQ(message_of([] { read_map_file("~/none.yaml"); }),
            (folder_ / "my maps/none.yaml") + ": file: expected an existing file");
  setenv("HOME", home.c_str(), 1);
}

std::vector<int> meanings(const OccupancyGrid& grid)
{
  std::vector<int> result;
  for (const std::int8_t cell : grid.data)
    result.push_back(cell < 0 || cell > 100 ? -1 : ObstacleRule{}.is_obstacle(cell));
  return result;
}

TEST_F(MapFile, ReadsBackWhatItWrote)
{
  Random random(2);
  for (int i = 0; i < 100; ++i)
  {
    SCOPED_TRACE("seed 2, grid " + std::to_string(i));
    const int width = random.whole(1, 40), height = random.whole(1, 40);
    OccupancyGrid grid = free_grid(width, height, std::exp(random.between(-10.0, 10.0)));
    grid.origin = {random.between(-10.0, 10.0), random.between(-10.0, 10.0), random.between(-10.0, 10.0)};
    for (std::int8_t& value : grid.data) value = static_cast<std::int8_t>(random.whole(-128, 127));
    write_map_file(grid, folder_ / "a \"map\": #1");
    const OccupancyGrid back = read_map_file(folder_ / "a \"map\": #1.yaml");
    ASSERT_EQ(back.width, grid.width);
    ASSERT_EQ(back.height, grid.height);
    EXPECT_EQ(back.resolution, grid.resolution);
    EXPECT_EQ(back.origin.x, grid.origin.x);
    EXPECT_EQ(back.origin.y, grid.origin.y);
    EXPECT_EQ(back.origin.theta, grid.origin.theta);
    EXPECT_EQ(meanings(back), meanings(grid));
  }
}

TEST_F(MapFile, RejectsToWriteAnUnusableGridOrToAnUnusablePlace)
{
  const OccupancyGrid good = free_grid(1, 1, 0.1);
  OccupancyGrid bad = good;
  bad.data.clear();
  EXPECT_NE(message_of([&] { write_map_file(bad, folder_ / "map"); }), "");
  EXPECT_NE(message_of([&] { write_map_file(good, folder_ / "absent/map"); }), "");
}

}  // namespace
}  // namespace fourwis
