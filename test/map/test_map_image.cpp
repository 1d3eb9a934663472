#include "fourwis_navigation/map/map_file.h"

#include <gtest/gtest.h>

#include "../support/fuzz_rounds.h"
#include "image_bytes.h"
#include "map_fixture.h"

namespace fourwis
{
namespace
{

using MapImage = MapFixture;

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

/// `greys` with a block of 8 x 8 pixels for each, which a JPEG of the best quality keeps to the bit.
Rows blocks(std::size_t samples)
{
  Rows rows;
  for (const auto& row : greys)
  {
    std::vector<std::uint8_t> wide;
    for (const std::uint8_t grey : row) wide.insert(wide.end(), 8 * samples, grey);
    rows.insert(rows.end(), 8, wide);
  }
  return rows;
}

TEST_F(MapImage, ReadsEveryKindOfBmpAndTiffAlike)
{
  const auto repeat = [](std::size_t times) {
    return converted([times](std::uint8_t grey, auto& row) { row.insert(row.end(), times, grey); });
  };
  const auto with_fourth = [](std::uint8_t fourth) {
    return converted([fourth](std::uint8_t grey, auto& row) {
      row.insert(row.end(), 3, grey);
      row.push_back(fourth);
    });
  };
  const Rows indices = converted([](std::uint8_t grey, auto& row) { row.push_back(255 - grey); });
  EXPECT_EQ(read_image_bytes(bmp_bytes(4, indices, 8)).data, grey_cells);
  EXPECT_EQ(read_image_bytes(bmp_bytes(4, repeat(3), 24)).data, grey_cells);
  EXPECT_EQ(read_image_bytes(bmp_bytes(4, with_fourth(0), 32)).data, grey_cells) << "no alpha";
  EXPECT_EQ(read_image_bytes(tiff_bytes(4, greys, 1)).data, grey_cells);
  EXPECT_EQ(read_image_bytes(tiff_bytes(4, repeat(3), 3)).data, grey_cells);
  EXPECT_EQ(read_image_bytes(tiff_bytes(4, with_fourth(255), 4)).data, grey_cells);
  EXPECT_EQ(read_image_bytes(tiff_bytes(4, with_fourth(254), 4)).data, std::vector<std::int8_t>(8, -1));
}

TEST_F(MapImage, ReadsEveryKindOfJpegAlike)
{
  for (const int samples : {1, 3})
  {
    const OccupancyGrid grid = read_image_bytes(jpeg_bytes(32, blocks(static_cast<std::size_t>(samples)), samples));
    ASSERT_EQ(grid.width, 32);
    ASSERT_EQ(grid.height, 16);
    for (int row = 0; row < 16; ++row)
      for (int column = 0; column < 32; ++column)
        ASSERT_EQ(grid.at(column, row), grey_cells[static_cast<std::size_t>(row / 8 * 4 + column / 8)])
            << samples << " at " << column << ", " << row;
  }
}

TEST_F(MapImage, AveragesTheColoursOfBmpAndTiff)
{
  // Mean 85 is occupied although one of its colours is bright.
  const Rows pixel{{255, 0, 0}};
  EXPECT_EQ(read_image_bytes(bmp_bytes(1, pixel, 24), {{"mode", "raw"}}).data, (std::vector<std::int8_t>{85}));
  EXPECT_EQ(read_image_bytes(tiff_bytes(1, pixel, 3), {{"mode", "raw"}}).data, (std::vector<std::int8_t>{85}));
}

TEST_F(MapImage, SaysWhatItExpectedOfADefectiveBmpTiffOrJpeg)
{
  testing::internal::CaptureStderr();
  const std::string jpeg = jpeg_bytes(32, blocks(1), 1);
  const std::vector<std::pair<std::string, std::string>> defects = {
      {"BM is how it begins", "BMP"},
      {std::string("II*\0\x08\0\0\0", 8), "TIFF"},
      {"\xff\xd8\xff", "JPEG"},
      {jpeg.substr(0, jpeg.size() / 2), "JPEG"},
      {jpeg.substr(0, jpeg.size() - 6), "complete JPEG data"},
      {"GIF89a", "expected a PGM (P2 or P5), PNG, JPEG, BMP or TIFF image"},
      {"no picture, whatever its name says", "expected a PGM (P2 or P5), PNG, JPEG, BMP or TIFF image"}};
  for (const auto& [bytes, expected] : defects)
  {
    const std::string message = rejection_of_image(bytes);
    EXPECT_NE(message.find(folder_ / "map.pgm"), std::string::npos) << message;
    EXPECT_NE(message.find(expected), std::string::npos) << message;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "the libraries say nothing themselves";
}

TEST_F(MapImage, RefusesTheSizeOfABmpTiffOrJpegBeforeItIsAllocated)
{
  std::string jpeg = jpeg_bytes(8, Rows(8, std::vector<std::uint8_t>(8, 0)), 1);
  jpeg.replace(jpeg.find("\xff\xc0") + 5, 4, "\xff\xdc\xff\xdc");  // height and width
  EXPECT_NE(rejection_of_image(jpeg).find("65500 x 65500"), std::string::npos) << rejection_of_image(jpeg);
  std::string tiff = tiff_bytes(1, {{0}}, 1);
  for (const std::size_t entry : {0U, 1U}) tiff.replace(10 + 12 * entry + 8, 4, little(100000, 4));
  EXPECT_NE(rejection_of_image(tiff), "");
  std::string bmp = bmp_bytes(1, {{0}}, 8);
  for (const std::size_t field : {18U, 22U}) bmp.replace(field, 4, little(100000, 4));
  EXPECT_NE(rejection_of_image(bmp), "");
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
    EXPECT_NE(rejection_of_image(bytes), "") << bytes;
}

TEST_F(MapImage, RejectsAHeaderThatPromisesMoreThanTheFileHolds)
{
  EXPECT_NE(rejection_of_image("P5 16384 16384 255\nabc").find("truncated"), std::string::npos);
  EXPECT_NE(rejection_of_image("P2 16384 16384 255\n1 2 3").find("truncated"), std::string::npos);
  EXPECT_NE(rejection_of_image("P5 16385 16384 255\nabc").find("size"), std::string::npos);
  EXPECT_NE(rejection_of_image("P5 1000000000 1000000000 255\nabc").find("size"), std::string::npos);
}

TEST_F(MapImage, RejectsAnImageCutShortAnywhereAndIgnoresWhatFollowsIt)
{
  const Rows rows{{0, 255, 205}, {255, 255, 0}};
  for (const std::string& bytes : {small_pgm, png_bytes(3, rows, {PNG_COLOR_TYPE_GRAY, 8}),
                                   png_bytes(3, rows, {PNG_COLOR_TYPE_GRAY, 8, true}), tiff_bytes(3, rows, 1)})
  {
    for (std::size_t size = 0; size < bytes.size(); ++size)
      EXPECT_NE(rejection_of_image(bytes.substr(0, size)), "") << size << " of " << bytes.size();
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
      {"map.pgm", png_bytes(3, {{0, 7, 51}}, {PNG_COLOR_TYPE_PALETTE, 8, true})},
      {"map.pgm", jpeg_bytes(32, blocks(3), 3)},
      {"map.pgm", bmp_bytes(4, greys, 8)},
      {"map.pgm", tiff_bytes(4, greys, 1)}};
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
