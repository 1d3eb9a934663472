#include "fourwis_navigation/map/octomap_projection.h"

#include <gtest/gtest.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "../support/fuzz_rounds.h"
#include "map_bytes.h"

namespace fourwis
{
namespace
{

constexpr int center = 1 << 15;  ///< key of the voxel that begins at 0
constexpr int reach = 40;        ///< the random trees lie within this many voxels of the origin

octomap::OcTreeKey key(int x, int y, int z)
{
  const auto shifted = [](int i) { return static_cast<octomap::key_type>(i + center); };
  return {shifted(x), shifted(y), shifted(z)};
}

/// Makes the voxels of a box occupied or free.
template <typename Tree>
void fill(Tree& tree, const std::array<int, 3>& corner, const std::array<int, 3>& size, bool is_occupied)
{
  for (int x = corner[0]; x < corner[0] + size[0]; ++x)
  {
    for (int y = corner[1]; y < corner[1] + size[1]; ++y)
    {
      for (int z = corner[2]; z < corner[2] + size[2]; ++z) tree.setNodeValue(key(x, y, z), is_occupied ? 2.0F : -1.0F);
    }
  }
}

/// Boxes and single voxels, with large leaves where boxes allow it.
template <typename Tree>
Tree random_tree(Random& random, double resolution)
{
  Tree tree(resolution);
  for (int i = 0; i < 60; ++i)
  {
    const int size = i % 3 == 0 ? random.whole(4, 17) : random.whole(1, 3);
    const auto place = [&] { return random.whole(-reach, reach - size); };
    fill(tree, {place(), place(), place()}, {size, size, size}, random.chance(0.5));
  }
  tree.updateInnerOccupancy();
  tree.prune();
  return tree;
}

/// What a column of voxels projects to, by looking at each of them; lower and upper bound in voxels.
template <typename Tree>
int column_value(const Tree& tree, int x, int y, double lower, double upper)
{
  int value = -1;
  for (int z = -reach - 1; z <= reach; ++z)
  {
    const auto* node = z + 1 > lower && z < upper ? tree.search(key(x, y, z)) : nullptr;
    if (node) value = std::max(value, tree.isNodeOccupied(node) ? 100 : 0);
  }
  return value;
}

/// The grid's value at a voxel column, unknown outside.
int grid_value(const OccupancyGrid& grid, int x, int y)
{
  if (grid.data.empty()) return -1;
  const int column = x - static_cast<int>(std::lround(grid.origin.x / grid.resolution));
  const int row = y - static_cast<int>(std::lround(grid.origin.y / grid.resolution));
  const bool is_inside = column >= 0 && row >= 0 && column < grid.width && row < grid.height;
  return is_inside ? grid.at(column, row) : -1;
}

template <typename Tree>
void expect_projection(const Tree& tree, const std::string& path, double lower, double upper)
{
  const double resolution = tree.getResolution();
  OccupancyGrid grid;
  const std::string rejection = message_of([&] {
    grid = project_octomap_file(path, {lower * resolution, upper * resolution});
  });
  ASSERT_EQ(grid.data.size(), static_cast<std::size_t>(grid.width * grid.height));
  EXPECT_EQ(grid.origin.theta, 0.0);
  int wrong = 0, known = 0;
  for (int x = -reach - 2; x <= reach + 2; ++x)
  {
    for (int y = -reach - 2; y <= reach + 2; ++y)
    {
      const int value = column_value(tree, x, y, lower, upper);
      known += value >= 0;
      wrong += grid_value(grid, x, y) != value;
    }
  }
  EXPECT_EQ(rejection.empty(), known > 0) << rejection;
  EXPECT_EQ(wrong, 0) << "columns, band " << lower << " to " << upper << " voxels";
}

class OctomapProjection : public testing::Test
{
protected:
  std::string write(octomap::OcTree& tree) const
  {
    tree.writeBinary(folder_ / "map.bt");
    return folder_ / "map.bt";
  }

  std::string rejection_of(const std::string& bytes, const HeightBand& band = {-1.0, 1.0}) const
  {
    write_bytes(folder_ / "map.bt", bytes);
    return message_of([&] { project_octomap_file(folder_ / "map.bt", band); });
  }

  TemporaryDirectory folder_;
};

TEST_F(OctomapProjection, AgreesWithLookingAtEveryVoxel)
{
  Random random(3);
  for (const double resolution : {0.08, 0.1, 0.25})
  {
    for (int i = 0; i < 4; ++i)
    {
      SCOPED_TRACE("seed 3, resolution " + std::to_string(resolution) + ", tree " + std::to_string(i));
      octomap::OcTree tree = random_tree<octomap::OcTree>(random, resolution);
      tree.write(folder_ / "map.ot");
      for (const double lower : {-7.5, -3.0, 0.0, 2.25})
      {
        for (const double thickness : {0.5, 1.0, 8.0, 12.4})
        {
          expect_projection(tree, folder_ / "map.ot", lower, lower + thickness);
          octomap::OcTree copy(tree);
          expect_projection(tree, write(copy), lower, lower + thickness);
        }
      }
    }
  }
}

TEST_F(OctomapProjection, ReadsColouredTrees)
{
  Random random(4);
  auto tree = random_tree<octomap::ColorOcTree>(random, 0.1);
  tree.write(folder_ / "map.ot");
  expect_projection(tree, folder_ / "map.ot", -3.0, 4.5);
  octomap::ColorOcTree copy(tree);
  copy.writeBinary(folder_ / "map.bt");
  expect_projection(tree, folder_ / "map.bt", -3.0, 4.5);
}

TEST_F(OctomapProjection, CoversJustTheKnownVoxelsOfTheBand)
{
  octomap::OcTree tree(0.1);
  fill(tree, {-3, 2, 0}, {1, 1, 1}, true);
  fill(tree, {4, 7, 1}, {1, 1, 1}, false);
  fill(tree, {20, 20, 5}, {1, 1, 1}, true);
  tree.updateInnerOccupancy();
  const OccupancyGrid grid = project_octomap_file(write(tree), {0.0, 0.2});
  EXPECT_EQ(grid.width, 8);
  EXPECT_EQ(grid.height, 6);
  EXPECT_NEAR(grid.origin.x, -0.3, 1e-12);
  EXPECT_NEAR(grid.origin.y, 0.2, 1e-12);
  EXPECT_EQ(grid.at(0, 0), 100);
  EXPECT_EQ(grid.at(7, 5), 0);
  EXPECT_EQ(grid.at(1, 0), -1);
}

TEST_F(OctomapProjection, DoesNotCountVoxelsThatOnlyTouchTheBand)
{
  octomap::OcTree tree(0.1);
  fill(tree, {0, 0, 0}, {1, 1, 9}, false);
  fill(tree, {0, 0, 3}, {1, 1, 1}, true);  // from 0.3 to 0.4
  tree.updateInnerOccupancy();
  const std::string path = write(tree);
  EXPECT_EQ(project_octomap_file(path, {0.4, 0.9}).at(0, 0), 0);
  EXPECT_EQ(project_octomap_file(path, {0.1, 0.3}).at(0, 0), 0);
  EXPECT_EQ(project_octomap_file(path, {0.1, 3 * 0.1}).at(0, 0), 0);  // 3 * 0.1 exceeds 0.3 by rounding
  EXPECT_EQ(project_octomap_file(path, {0.39, 0.9}).at(0, 0), 100);
  EXPECT_EQ(project_octomap_file(path, {0.1, 0.31}).at(0, 0), 100);
}

TEST_F(OctomapProjection, TakesAHugeBandForAllHeights)
{
  Random random(5);
  octomap::OcTree tree = random_tree<octomap::OcTree>(random, 0.1);
  tree.write(folder_ / "map.ot");
  const auto everything = project_octomap_file(folder_ / "map.ot", {-1e6, 1e6});
  EXPECT_EQ(everything.data, project_octomap_file(folder_ / "map.ot", {-10.0, 10.0}).data);
}

TEST_F(OctomapProjection, RejectsAFileWithoutKnownVoxelsInTheBand)
{
  octomap::OcTree tree(0.1);
  EXPECT_NE(message_of([&] { project_octomap_file(write(tree), {0.0, 1.0}); }), "");
  fill(tree, {0, 0, 0}, {1, 1, 1}, true);
  tree.updateInnerOccupancy();
  const std::string path = write(tree);
  const std::string message = message_of([&] { project_octomap_file(path, {0.5, 1.0}); });
  EXPECT_EQ(message, path + ": data: expected known voxels in the height band, got none");
}

TEST_F(OctomapProjection, RejectsABandThatIsNone)
{
  octomap::OcTree tree(0.1);
  const std::string path = write(tree);
  for (const HeightBand& band :
       {HeightBand{1.0, 1.0}, HeightBand{1.0, 0.0}, HeightBand{std::nan(""), 1.0}, HeightBand{0.0, INFINITY}})
    EXPECT_THROW(project_octomap_file(path, band), std::invalid_argument);
}

TEST_F(OctomapProjection, RejectsWhatIsNotAnOctomapByField)
{
  const std::string start = "# Octomap OcTree binary file\n";
  const std::vector<std::pair<std::string, std::string>> defects{
      {"", "format"},
      {"P5 1 1 255\n1", "format"},
      {start, "data"},
      {start + "id OcTree\nsize 1\nres 0.1\n", "data"},
      {start + "id OcTree\nsize 1\nres 0.1\ndata", "data"},
      {start + "id OcTree\nsize 1\nres -0.1\ndata\n  ", "res"},
      {start + "id OcTree\nsize 1\nres nan\ndata\n  ", "res"},
      {start + "id OcTree\nsize 1\ndata\n  ", "res"},
      {start + "size 1\nres 0.1\ndata\n  ", "id"},
      {start + "id Quadtree\nsize 1\nres 0.1\ndata\n  ", "id"},
      {start + "id OcTree\nres 0.1\ndata\n  ", "size"},
      {start + "id OcTree\nsize many\nres 0.1\ndata\n  ", "size"},
      {start + "id OcTree\nsize 5\nres 0.1\ndata\n" + std::string("\x01\x00", 2), "size"},
      {start + "id OcTree\nsize 5\nres 0.1\ndata\n" + std::string(100000, '\xff'), "data"},
      {start + "id OcTree\nsize 5\nres 0.1\ndata\n" + std::string(100000, '\0'), "data"},
      {"# Octomap OcTree file\nid OcTree\nsize 5\nres 0.1\ndata\n" + std::string(100000, '\x3f'), "data"},
      {start + "id OcTree\nsize 9\nres 0.1\ndata\n\x55\x55", "data"}};  // eight voxels, each an eighth of everything
  for (const auto& [bytes, field] : defects)
    EXPECT_EQ(rejection_of(bytes).rfind(folder_ / "map.bt" + ": " + field + ": ", 0), 0U) << rejection_of(bytes);
  EXPECT_NE(message_of([&] { project_octomap_file(folder_ / "absent.bt", {}); }), "");
  EXPECT_NE(message_of([&] { project_octomap_file(folder_ / ".", {}); }), "");
}

TEST_F(OctomapProjection, RejectsAFileCutShortAnywhereAndSurvivesRandomDamage)
{
  Random random(6);
  octomap::OcTree tree(0.1);
  fill(tree, {-3, -2, 0}, {4, 3, 2}, true);
  fill(tree, {1, 2, 0}, {2, 5, 3}, false);
  tree.updateInnerOccupancy();
  tree.write(folder_ / "map.ot");
  write(tree);
  for (const std::string& bytes : {read_bytes(folder_ / "map.bt"), read_bytes(folder_ / "map.ot")})
  {
    for (std::size_t size = 0; size < bytes.size(); ++size)
      EXPECT_NE(rejection_of(bytes.substr(0, size)), "") << size << " of " << bytes.size();
    EXPECT_EQ(rejection_of(bytes + "garbage"), "");
    int refused = 0;
    for (int i = 0; i < fuzz_rounds(2000); ++i)
    {
      SCOPED_TRACE("seed 6, mutation " + std::to_string(i));
      ASSERT_NO_THROW(refused += rejection_of(mutated(bytes, random)).empty() ? 0 : 1);
    }
    EXPECT_GT(refused, 500);
  }
}

}  // namespace
}  // namespace fourwis
