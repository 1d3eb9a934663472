#include "fourwis_navigation/map/map_file.h"

#include <gtest/gtest.h>

#include "../support/fuzz_rounds.h"
#include "map_fixture.h"

namespace fourwis
{
namespace
{

using MapImage = MapFixture;
using Rows = std::vector<std::vector<std::uint8_t>>;

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
    for (const std::uint8_t grey : row) convert(grey, rows.back());
  }
  return rows;
}

TEST_F(MapImage, ReadsEveryKindOfPgmAlike)
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
  const std::string fifths("\x00\x33\x29\x1a\x33\x00\x1e\x33", 8);
  EXPECT_EQ(read_image_bytes("P5\n# a\n4 2\n# b\n51# c\n" + fifths).data, grey_cells);
}

TEST_F(MapImage, ReadsEveryKindOfPngAlike)
{
  const auto repeat = [](std::size_t times) {
    return converted([times](std::uint8_t grey, auto& row) { row.insert(row.end(), times, grey); });
  };
  const auto with_alpha = [](std::size_t colours) {
    return converted([colours](std::uint8_t grey, auto& row) {
      row.insert(row.end(), colours, grey);
      row.push_back(255);
    });
  };
  const Rows indices = converted([](std::uint8_t grey, auto& row) { row.push_back(grey / 5); });
  const std::vector<std::pair<PngKind, Rows>> kinds{{{PNG_COLOR_TYPE_GRAY, 8}, greys},
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

TEST_F(MapImage, AveragesTheColoursAndTakesTransparentPixelsForUnknown)
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

TEST_F(MapImage, RejectsADefectiveImage)
{
  for (const char* bytes :
       {"", "P", "P2", "P5", "P6 1 1 255\nabc", "GIF89a", "P5 0 1 255\n", "P5 -1 1 255\n1", "P5 1 1 0\n1",
        "P5 1 1 65536\n11", "P5 x 1 255\n1", "P5 1 1 255", "P5 1 1 100\n\xff", "P2 1 1 255 256", "P2 2 1 255 1 x",
        "P2 2 1 255 11 ", "P5 99999999999999999999 1 255\n1", "\x89PNG\r\n\x1a\n"})
    EXPECT_NE(refusal_of_image(bytes), "") << bytes;
}

TEST_F(MapImage, RejectsAHeaderThatPromisesMoreThanTheFileHolds)
{
  EXPECT_NE(refusal_of_image("P5 16384 16384 255\nabc").find("truncated"), std::string::npos);
  EXPECT_NE(refusal_of_image("P2 16384 16384 255\n1 2 3").find("truncated"), std::string::npos);
  EXPECT_NE(refusal_of_image("P5 16385 16384 255\nabc").find("size"), std::string::npos);
  EXPECT_NE(refusal_of_image("P5 1000000000 1000000000 255\nabc").find("size"), std::string::npos);
}

TEST_F(MapImage, RejectsAnImageCutShortAnywhereAndIgnoresWhatFollowsIt)
{
  const Rows rows{{0, 255, 205}, {255, 255, 0}};
  for (const std::string& bytes :
       {small_pgm, png_bytes(3, rows, {PNG_COLOR_TYPE_GRAY, 8}), png_bytes(3, rows, {PNG_COLOR_TYPE_GRAY, 8, true})})
  {
    for (std::size_t size = 0; size < bytes.size(); ++size)
      EXPECT_NE(refusal_of_image(bytes.substr(0, size)), "") << size << " of " << bytes.size();
    EXPECT_EQ(read_image_bytes(bytes + "garbage").data, small_cells);
  }
}

TEST_F(MapImage, SurvivesRandomDamage)
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
    Random random(1);
    write_bytes(folder_ / "map.yaml", yaml);
    write_bytes(folder_ / "map.pgm", small_pgm);
    int refused = 0;
    for (int i = 0; i < fuzz_rounds(2000); ++i)
    {
      SCOPED_TRACE(name + ", seed 1, mutation " + std::to_string(i));
      write_bytes(folder_ / name, mutated(original, random));
      ASSERT_NO_THROW(refused += message_of([&] { read_map_file(folder_ / "map.yaml"); }).empty() ? 0 : 1);
    }
    EXPECT_GT(refused, 500) << name;
  }
}

}  // namespace
}  // namespace fourwis
