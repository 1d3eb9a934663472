#include "fourwis_navigation/map/map_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "map_bytes.h"

namespace fourwis
{
namespace
{

using Rows = std::vector<std::vector<std::uint8_t>>;

/// A map of which single fields can be changed; an empty text leaves a field out.
class MapFile : public testing::Test
{
protected:
  std::string write_yaml(const std::map<std::string, std::string>& changes = {}) const
  {
    std::map<std::string, std::string> fields{{"image", "map.pgm"}, {"resolution", "0.05"}, {"origin", "[-1, 2.5, 0.3]"},
                                              {"negate", "0"}, {"occupied_thresh", "0.65"}, {"free_thresh", "0.196"}};
    for (const auto& change : changes)
      fields[change.first] = change.second;
    std::string text;
    for (const auto& field : fields)
      text += field.second.empty() ? "" : field.first + ": " + field.second + "\n";
    write_bytes(folder_ / "map.yaml", text);
    return folder_ / "map.yaml";
  }

  OccupancyGrid read_image_bytes(const std::string& bytes, const std::map<std::string, std::string>& changes = {}) const
  {
    write_bytes(folder_ / "map.pgm", bytes);
    return read_map_file(write_yaml(changes));
  }

  std::string refusal_of_image(const std::string& bytes) const
  {
    return message_of([&] { read_image_bytes(bytes); });
  }

  TemporaryDirectory folder_;
};

std::string pgm(int width, int height, const std::string& samples)
{
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" + samples;
}

const std::string small_pgm = pgm(3, 2, std::string("\x00\xfe\xcd\xfe\xfe\x00", 6));
const std::vector<std::int8_t> small_cells{0, 0, 100, 100, 0, -1};

/// Greys and what they mean in the standard trinary map.
const Rows greys{{0, 255, 205, 130}, {255, 0, 150, 255}};
const std::vector<std::int8_t> grey_cells{0, 100, -1, 0, 100, 0, -1, -1};

/// `greys` with every pixel's sample written by `convert`.
template <typename Convert>
Rows converted(const Convert& convert)
{
  Rows rows;
  for (const auto& row : greys)
  {
    rows.emplace_back();
    for (const std::uint8_t grey : row)
      convert(grey, rows.back());
  }
  return rows;
}

/// map_server's formulas, written down separately.
int value_by_formula(int grey, bool negate, const std::string& mode)
{
  const int level = negate ? 255 - grey : grey;
  if (mode == "raw")
    return level < 128 ? level : level - 256;
  const double p = (255 - level) / 255.0;
  if (p > 0.65)
    return 100;
  if (p < 0.196)
    return 0;
  return mode == "scale" ? static_cast<int>(std::floor(1 + 98 * (p - 0.196) / (0.65 - 0.196))) : -1;
}

TEST_F(MapFile, takes_the_images_lowest_row_as_the_grids_first)
{
  const OccupancyGrid grid = read_image_bytes(small_pgm);
  EXPECT_EQ(grid.width, 3);
  EXPECT_EQ(grid.height, 2);
  EXPECT_EQ(grid.data, small_cells);
}

TEST_F(MapFile, takes_resolution_and_origin_with_yaw_from_the_yaml)
{
  const OccupancyGrid grid = read_image_bytes(small_pgm);
  EXPECT_EQ(grid.resolution, 0.05);
  EXPECT_EQ(grid.origin.x, -1.0);
  EXPECT_EQ(grid.origin.y, 2.5);
  EXPECT_EQ(grid.origin.theta, 0.3);
}

TEST_F(MapFile, gives_every_grey_level_map_servers_value_in_every_mode)
{
  std::string all;
  for (int grey = 0; grey < 256; ++grey)
    all += static_cast<char>(grey);
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

TEST_F(MapFile, accepts_numbers_and_words_for_negate)
{
  for (const char* yes : {"1", "true"})
    EXPECT_EQ(read_image_bytes(small_pgm, {{"negate", yes}}).at(2, 0), 0) << yes;
  for (const char* no : {"0", "false"})
    EXPECT_EQ(read_image_bytes(small_pgm, {{"negate", no}}).at(2, 0), 100) << no;
}

TEST_F(MapFile, finds_an_image_by_its_absolute_path)
{
  EXPECT_EQ(read_image_bytes(small_pgm, {{"image", folder_ / "map.pgm"}}).data, small_cells);
}

TEST_F(MapFile, accepts_equal_thresholds_in_every_mode)
{
  for (const char* mode : {"trinary", "scale"})
  {
    const auto cells =
      read_image_bytes(pgm(3, 1, "\x33\xcc\xff"), {{"occupied_thresh", "0.2"}, {"free_thresh", "0.2"}, {"mode", mode}}).data;
    EXPECT_EQ(cells, (std::vector<std::int8_t>{100, -1, 0})) << mode;
  }
}

TEST_F(MapFile, reads_every_kind_of_pgm_alike)
{
  std::string deep = "P5 4 2 65535\n", plain = "P2 # plain\n#size\n4 #wide\n 2 # high\n255#greys\n";
  for (const auto& row : greys)
  {
    for (const int grey : row)
    {
      deep += {static_cast<char>(grey), static_cast<char>(grey)};
      plain += std::to_string(grey) + " ";
    }
  }
  EXPECT_EQ(read_image_bytes(deep).data, grey_cells);
  EXPECT_EQ(read_image_bytes(plain).data, grey_cells);
  EXPECT_EQ(read_image_bytes("P5\n# a\n4 2\n# b\n51# c\n" + std::string("\x00\x33\x29\x1a\x33\x00\x1e\x33", 8)).data, grey_cells);
}

TEST_F(MapFile, reads_every_kind_of_png_alike)
{
  const auto repeat = [](int times) {
    return converted([times](std::uint8_t grey, auto& row) { row.insert(row.end(), times, grey); });
  };
  const auto with_alpha = [](int colours) {
    return converted([colours](std::uint8_t grey, auto& row) {
      row.insert(row.end(), colours, grey);
      row.push_back(255);
    });
  };
  const Rows indices = converted([](std::uint8_t grey, auto& row) { row.push_back(grey / 5); });
  const std::vector<std::pair<PngKind, Rows>> kinds{
    {{PNG_COLOR_TYPE_GRAY, 8}, greys},
    {{PNG_COLOR_TYPE_GRAY, 8, true}, greys},
    {{PNG_COLOR_TYPE_GRAY, 16}, repeat(2)},
    {{PNG_COLOR_TYPE_GRAY_ALPHA, 8}, with_alpha(1)},
    {{PNG_COLOR_TYPE_RGB, 8}, repeat(3)},
    {{PNG_COLOR_TYPE_RGB, 16}, repeat(6)},
    {{PNG_COLOR_TYPE_RGB_ALPHA, 8}, with_alpha(3)},
    {{PNG_COLOR_TYPE_RGB_ALPHA, 8, true}, with_alpha(3)},
    {{PNG_COLOR_TYPE_PALETTE, 8}, indices}};
  for (const auto& [kind, rows] : kinds)
    EXPECT_EQ(read_image_bytes(png_bytes(4, rows, kind)).data, grey_cells) << kind.colour_type << " " << kind.depth;
  const Rows bits{{0xa0}};
  EXPECT_EQ(read_image_bytes(png_bytes(3, bits, {PNG_COLOR_TYPE_GRAY, 1})).data, (std::vector<std::int8_t>{0, 100, 0}));
}

TEST_F(MapFile, averages_the_colours_and_takes_transparent_pixels_for_unknown)
{
  // Mean 85 is occupied although its blue is bright; black and white are unknown where something shines through.
  const Rows rows{{0, 0, 255, 255, /**/ 0, 0, 0, 254, /**/ 255, 255, 255, 0}};
  const std::string png = png_bytes(3, rows, {PNG_COLOR_TYPE_RGB_ALPHA, 8});
  EXPECT_EQ(read_image_bytes(png).data, (std::vector<std::int8_t>{100, -1, -1}));
  EXPECT_EQ(read_image_bytes(png, {{"mode", "scale"}}).data, (std::vector<std::int8_t>{100, -1, -1}));
  EXPECT_EQ(read_image_bytes(png, {{"mode", "raw"}}).data, (std::vector<std::int8_t>{85, 0, -1}));
  const std::string palette = png_bytes(3, {{0, 7, 51}}, {PNG_COLOR_TYPE_PALETTE, 8});
  EXPECT_EQ(read_image_bytes(palette).data, (std::vector<std::int8_t>{100, -1, 0}));
}

TEST_F(MapFile, refuses_a_defective_field_by_its_name)
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

TEST_F(MapFile, refuses_what_is_not_a_map_file)
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

TEST_F(MapFile, refuses_a_defective_image)
{
  for (const char* bytes : {"", "P", "P2", "P5", "P6 1 1 255\nabc", "GIF89a", "P5 0 1 255\n", "P5 -1 1 255\n1",
                            "P5 1 1 0\n1", "P5 1 1 65536\n11", "P5 x 1 255\n1", "P5 1 1 255", "P5 1 1 100\n\xff",
                            "P2 1 1 255 256", "P2 2 1 255 1 x", "P2 2 1 255 11 ", "P5 99999999999999999999 1 255\n1",
                            "\x89PNG\r\n\x1a\n"})
    EXPECT_NE(refusal_of_image(bytes), "") << bytes;
}

TEST_F(MapFile, refuses_a_header_that_promises_more_than_the_file_holds)
{
  EXPECT_NE(refusal_of_image("P5 16384 16384 255\nabc").find("truncated"), std::string::npos);
  EXPECT_NE(refusal_of_image("P2 16384 16384 255\n1 2 3").find("truncated"), std::string::npos);
  EXPECT_NE(refusal_of_image("P5 16385 16384 255\nabc").find("size"), std::string::npos);
  EXPECT_NE(refusal_of_image("P5 1000000000 1000000000 255\nabc").find("size"), std::string::npos);
}

TEST_F(MapFile, refuses_an_image_cut_short_anywhere_and_ignores_what_follows_it)
{
  const Rows rows{{0, 255, 205}, {255, 255, 0}};
  for (const std::string& bytes : {small_pgm, png_bytes(3, rows, {PNG_COLOR_TYPE_GRAY, 8}),
                                   png_bytes(3, rows, {PNG_COLOR_TYPE_GRAY, 8, true})})
  {
    for (std::size_t size = 0; size < bytes.size(); ++size)
      EXPECT_NE(refusal_of_image(bytes.substr(0, size)), "") << size << " of " << bytes.size();
    EXPECT_EQ(read_image_bytes(bytes + "garbage").data, small_cells);
  }
}

TEST_F(MapFile, survives_random_damage)
{
  const std::string yaml = read_bytes(write_yaml({{"mode", "scale"}}));
  const std::vector<std::pair<std::string, std::string>> originals{
    {"map.yaml", yaml},
    {"map.pgm", small_pgm},
    {"map.pgm", "P2\n# plain\n3 2\n255\n0 254 205\n254 254 0\n"},
    {"map.pgm", png_bytes(4, greys, {PNG_COLOR_TYPE_GRAY, 8})},
    {"map.pgm", png_bytes(3, {{0, 7, 51}}, {PNG_COLOR_TYPE_PALETTE, 8, true})}};
  for (const auto& [name, original] : originals)
  {
    std::mt19937 random(1);
    write_bytes(folder_ / "map.yaml", yaml);
    write_bytes(folder_ / "map.pgm", small_pgm);
    int refused = 0;
    for (int i = 0; i < 2000; ++i)
    {
      SCOPED_TRACE(name + ", seed 1, mutation " + std::to_string(i));
      write_bytes(folder_ / name, mutated(original, random));
      ASSERT_NO_THROW(refused += message_of([&] { read_map_file(folder_ / "map.yaml"); }).empty() ? 0 : 1);
    }
    EXPECT_GT(refused, 500) << name;
  }
}

std::vector<int> meanings(const OccupancyGrid& grid)
{
  std::vector<int> result;
  for (const std::int8_t cell : grid.data)
    result.push_back(cell < 0 || cell > 100 ? -1 : ObstacleRule{}.is_obstacle(cell));
  return result;
}

TEST_F(MapFile, reads_back_what_it_wrote)
{
  std::mt19937 random(2);
  std::uniform_int_distribution<int> size(1, 40), cell(-128, 127);
  std::uniform_real_distribution<double> real(-10.0, 10.0);
  for (int i = 0; i < 100; ++i)
  {
    SCOPED_TRACE("seed 2, grid " + std::to_string(i));
    OccupancyGrid grid{size(random), size(random), std::exp(real(random)), {real(random), real(random), real(random)}, {}};
    for (int k = 0; k < grid.width * grid.height; ++k)
      grid.data.push_back(static_cast<std::int8_t>(cell(random)));
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

TEST_F(MapFile, refuses_to_write_an_unusable_grid_or_to_an_unusable_place)
{
  const OccupancyGrid good{1, 1, 0.1, {}, {0}};
  OccupancyGrid bad = good;
  bad.data.clear();
  EXPECT_NE(message_of([&] { write_map_file(bad, folder_ / "map"); }), "");
  EXPECT_NE(message_of([&] { write_map_file(good, folder_ / "absent/map"); }), "");
}

}  // namespace
}  // namespace fourwis
